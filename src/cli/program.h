// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::cli {

/// Runs the program. Parses the arguments, runs the command, and converts failures to messages and exit codes.
int runProgram(int argc, char** argv);

}  // namespace poinsot::cli
