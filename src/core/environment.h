// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace poinsot::core {

/// Removes the environment variables for whose names `isKept` returns false.
/// @pre no other thread reads the environment.
void clearEnvironment(const std::function<bool(std::string_view name)>& isKept);

}  // namespace poinsot::core
