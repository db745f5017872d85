// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::cli {

/// The whole program: parses, runs the command, turns every failure into its message and exit code.
int runProgram(int argc, char** argv);

}  // namespace poinsot::cli
