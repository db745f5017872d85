// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace poinsot::cli {

struct Variable {
  const char* name;
  const char* help;
};

/// Returns all variables in the order of the manual. docs/defaults.md lists the same ones.
std::span<const Variable> variables();

/// Removes all other variables from the environment, before a library reads one. The libraries that draw, set type
/// and encode read more than 180 variables, and a list of these names would miss those of the next release.
///
/// Keeps what the dynamic linker and sanitizers read before main(): removing these variables here would only
/// change the render that a preview starts.
/// @pre this process has one thread.
void clearOtherVariables();

}  // namespace poinsot::cli
