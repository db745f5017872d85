// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>

namespace poinsot::bench {

/// Work whose instructions are counted: it does the same on each call, on one thread, and depends on no other
/// state.
using Work = std::function<void()>;

/// Returns, by the name of each part, the function that makes its work. Preparations in the function are not
/// counted.
const std::map<std::string, Work (*)()>& guardedParts();

}  // namespace poinsot::bench
