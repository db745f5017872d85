// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "job/checkup.h"
#include "process/interrupt.h"

namespace poinsot::cli {
namespace {

constexpr std::size_t kText = 24;  // column where the text of a finding begins

const char* wordFor(job::Finding::State state) {
  switch (state) {
    case job::Finding::State::kGood:
      return "ok";
    case job::Finding::State::kAbsent:
      return "absent";
    case job::Finding::State::kBad:
      break;
  }
  return "BAD";
}

int doctor() {
  process::watchInterrupts();
  writeOut(versionText());
  bool good = true;
  for (const job::Finding& finding : job::checkup()) {
    const std::string start = fmt::format("{:<8}{:<14}  ", wordFor(finding.state), finding.subject);
    writeOut(start + wrapped(finding.text, kColumns, kText, start.size()) + '\n');
    good &= finding.state != job::Finding::State::kBad;
  }
  return good ? kDone : kNo;
}

}  // namespace

void addDoctor(const Command& program) {
  const Command command = program.command(
      "doctor",
      "check what works on this machine (OpenGL, encoders, memory, a one-second film), and what to install");
  command.footer(
      "Example:\n"
      "  poinsot doctor\n"
      "Exit code 1 when no film can be made.");
  command.does({doctor});
}

}  // namespace poinsot::cli
