// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/checkup.h"
#include "app/interrupt.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/paragraph.h"

namespace poinsot::cli {
namespace {

constexpr std::size_t kText = 24;  // the column in which it begins

const char* wordFor(app::Finding::State state) {
  switch (state) {
    case app::Finding::State::kGood:
      return "ok";
    case app::Finding::State::kAbsent:
      return "absent";
    case app::Finding::State::kBad:
      break;
  }
  return "BAD";
}

int doctor() {
  app::watchInterrupts();
  writeOut(versionText());
  bool good = true;
  for (const app::Finding& finding : app::checkup()) {
    const std::string start = fmt::format("{:<8}{:<14}  ", wordFor(finding.state), finding.subject);
    writeOut(start + wrapped(finding.text, kColumns, kText, start.size()) + '\n');
    good &= finding.state != app::Finding::State::kBad;
  }
  return good ? kDone : kNo;
}

}  // namespace

void addDoctor(CLI::App& program, Action& chosen) {
  CLI::App* command = program.add_subcommand(
      "doctor",
      "say what of this machine works: OpenGL, encoders, memory, a film of a second; and what to install");
  command->footer(
      "Example:\n"
      "  poinsot doctor\n"
      "Exit code 1 when no film can be made.");
  command->callback([&chosen] { chosen = doctor; });
}

}  // namespace poinsot::cli
