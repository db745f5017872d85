// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace poinsot::gl {

/// Checks that the back end allocated memory. Must be called after each call that allocates.
/// @param what  what the memory is for, such as "a buffer"
/// @throws core::Error(kGraphics) if memory ran out or the call failed otherwise.
void expectStored(const char* what, std::size_t bytes);

}  // namespace poinsot::gl
