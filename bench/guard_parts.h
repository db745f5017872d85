// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>

namespace poinsot::bench {

/// What is counted: the same on each call, of one thread, a function of nothing but what it was made with.
using Work = std::function<void()>;

/// By the name of the part: makes its work. What that needs is set up here, and does not count.
const std::map<std::string, Work (*)()>& guardedParts();

}  // namespace poinsot::bench
