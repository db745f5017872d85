// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/program_text.h"

/// Scripts by which a shell completes the program's command line: commands, options, their values, keys of scenes
/// after -D, files of the right kind.
namespace poinsot::cli {

std::string bashCompletion(const ProgramText& text);
std::string zshCompletion(const ProgramText& text);
std::string fishCompletion(const ProgramText& text);

}  // namespace poinsot::cli
