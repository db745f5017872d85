// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/program_text.h"

namespace poinsot::cli {

/// "poinsot.1", or "poinsot-render.1" of a command.
std::string manPageName(const CommandText& command);

/// Manual page of a command, or of the program where it has no name; roff for the macros man(7).
std::string manPage(const ProgramText& text, const CommandText& command);

}  // namespace poinsot::cli
