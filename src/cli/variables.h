// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace poinsot::cli {

/// An environment variable that the program reads.
struct Variable {
  const char* name;
  const char* help;
};

/// All of them, in the order of the manual. docs/defaults.md has the same ones.
std::span<const Variable> variables();

/// Removes every other variable from the environment, before any library reads one. The libraries that draw, set
/// type and encode read more than 180 of them: to clear those by name would leave out those of the next release.
///
/// Kept as well is what is read before main(), by the dynamic linker and by sanitizers: clearing it here would
/// change nothing but the render that a preview starts.
/// @pre this process has one thread.
void clearOtherVariables();

}  // namespace poinsot::cli
