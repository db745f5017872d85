// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "scene/keys/reference.h"

namespace poinsot::cli {

void addSchema(const Command& program) {
  const Command command = program.command("schema", "print the JSON Schema of scene files, for editors");
  command.footer(
      "Example:\n"
      "  poinsot schema > out/scene.schema.json");
  command.does({[] {
    writeOut(scene::schemaJson());
    return static_cast<int>(kDone);
  }});
}

}  // namespace poinsot::cli
