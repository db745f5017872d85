// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string_view>

namespace poinsot::core {

/// Removes each variable of this process's environment whose name `isKept` refuses.
/// @pre no other thread reads the environment.
void clearEnvironment(const std::function<bool(std::string_view name)>& isKept);

}  // namespace poinsot::core
