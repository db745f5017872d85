// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "scene/keys/reference.h"

namespace poinsot::cli {

void addSchema(CLI::App& program, Action& chosen) {
  CLI::App* command = program.add_subcommand("schema", "print the JSON Schema of scene files, for editors");
  command->footer(
      "Example:\n"
      "  poinsot schema > out/scene.schema.json");
  command->callback([&chosen] {
    chosen.run = [] {
      writeOut(scene::schemaJson());
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace poinsot::cli
