// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/program_text.h"

/// Completion scripts for shells. The scripts complete commands, options, values, scene keys after -D, and file
/// names of the right kind.
namespace poinsot::cli {

std::string bashCompletion(const ProgramText& text);
std::string zshCompletion(const ProgramText& text);
std::string fishCompletion(const ProgramText& text);

}  // namespace poinsot::cli
