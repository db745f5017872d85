// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "app/worker.h"
#include "cli/commands.h"

namespace poinsot::cli {

void addWorker(CLI::App& program, Action& chosen) {
  CLI::App* command = program.add_subcommand("worker", "make segments for another poinsot");
  command->group("");  // not in the help: nobody types it
  command->callback([&chosen] { chosen = [] { return app::runWorker(STDIN_FILENO, STDOUT_FILENO); }; });
}

}  // namespace poinsot::cli
