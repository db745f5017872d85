// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <algorithm>
#include <csignal>

#include "cli/command_line.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/variables.h"

namespace poinsot::cli {

int runProgram(int argc, char** argv) {
  openStandardStreams();
  std::signal(SIGPIPE, SIG_IGN);  // a write says EPIPE in its place
  std::signal(SIGXFSZ, SIG_IGN);  // and EFBIG
  return translatingErrors([&] {
    clearOtherVariables();
    return CommandLine({argv + std::min(argc, 1), argv + argc}).run();
  });
}

}  // namespace poinsot::cli
