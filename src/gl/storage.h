// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace poinsot::gl {

/// Checks that the back end has allocated memory. Call this function after each OpenGL call that allocates.
/// @param what  purpose of the memory in messages, such as "a buffer"
/// @throws core::Error(kGraphics) if memory ran out or the call failed otherwise.
void expectStored(const char* what, std::size_t bytes);

}  // namespace poinsot::gl
