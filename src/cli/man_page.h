// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/program_text.h"

namespace poinsot::cli {

/// Returns "poinsot.1" for the program, or "poinsot-render.1" for a command.
std::string manPageName(const CommandText& command);

/// Returns the manual page of a command, or of the program if the command has no name, in roff format (man(7)).
std::string manPage(const ProgramText& text, const CommandText& command);

}  // namespace poinsot::cli
