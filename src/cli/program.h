// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::cli {

/// Runs the program: parses the arguments, runs the command, and turns every failure into a message and an exit
/// code.
int runProgram(int argc, char** argv);

}  // namespace poinsot::cli
