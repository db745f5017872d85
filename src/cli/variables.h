// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace poinsot::cli {

struct Variable {
  const char* name;
  const char* help;
};

/// Returns the environment variables of poinsot, in the order of the manual. docs/defaults.md lists the same
/// variables.
std::span<const Variable> variables();

/// Removes all environment variables except variables(), before any library reads them. The libraries for drawing,
/// text and video read more than 180 variables, and their next releases may read others.
///
/// Keeps the variables of the dynamic linker and the sanitizers, which have already been read before main().
/// @pre this process has one thread.
void clearOtherVariables();

}  // namespace poinsot::cli
