// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/text.h"
#include "gl/offscreen_context.h"

namespace poinsot::cli {
namespace {

int backends() {
  gl::pinEnvironment(false);
  bool any = false;
  for (const gl::BackendReport& report : gl::probeBackends()) {
    writeOut(fmt::format("{:<8}{:<8}{}\n", report.name, report.works ? "works" : "absent",
                         core::printable(report.detail)));
    any |= report.works;
  }
  return any ? kDone : kNo;
}

}  // namespace

void addBackends(const Command& program) {
  const Command command =
      program.command("backends", "list the OpenGL back ends: which work, what to install for the others");
  command.footer(
      "Example:\n"
      "  poinsot backends\n"
      "Exit code 1 when none works.");
  command.does({backends});
}

}  // namespace poinsot::cli
