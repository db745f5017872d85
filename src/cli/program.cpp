// SPDX-License-Identifier: Apache-2.0
#include "cli/program.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>

#include "cli/command_line.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/variables.h"

namespace poinsot::cli {
namespace {

/// Checks that the stack is large enough, because a stack overflow kills the process. The gallery needs 96 KiB;
/// nested scenes need more.
void requireStack() {
  constexpr rlim_t kLeast = 1 << 20;
  rlimit stack{};
  if (getrlimit(RLIMIT_STACK, &stack) == 0 && stack.rlim_cur < kLeast)
    throw std::runtime_error(fmt::format("the stack limit is {} KiB, but poinsot needs {} KiB; run: ulimit -s {}",
                                         stack.rlim_cur >> 10, kLeast >> 10, kLeast >> 10));
}

}  // namespace

int runProgram(int argc, char** argv) {
  openStandardStreams();
  std::signal(SIGPIPE, SIG_IGN);  // makes a failed write return EPIPE instead
  std::signal(SIGXFSZ, SIG_IGN);  // makes a failed write return EFBIG instead
  return translatingErrors([&] {
    requireStack();
    clearOtherVariables();
    return CommandLine({argv + std::min(argc, 1), argv + argc}).run();
  });
}

}  // namespace poinsot::cli
