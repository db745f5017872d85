// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace poinsot::gl {

/// To be asked after each call by which the back end sets memory aside. `what` it is for: "a buffer".
/// @throws core::Error(kGraphics) if it had none, or refused the call otherwise.
void expectStored(const char* what, std::size_t bytes);

}  // namespace poinsot::gl
