// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "cli/untrusted.h"

namespace CLI {
class App;
}

namespace poinsot::cli {

/// The command on the command line. Parsing chooses it and does nothing else.
struct Action {
  std::function<int()> run = {};                ///< returns the exit code
  const AllowanceOptions* allowance = nullptr;  ///< of a command that has --untrusted
  std::function<FileAccess()> access = {};      ///< what that one touches
};

/// Each declares one command with its options, and sets `chosen` when it is the one on the command line.
void addRender(CLI::App& program, Action& chosen);
void addStill(CLI::App& program, Action& chosen);
void addSweep(CLI::App& program, Action& chosen);
void addGallery(CLI::App& program, Action& chosen);
void addStatus(CLI::App& program, Action& chosen);
void addAssemble(CLI::App& program, Action& chosen);
void addSubmit(CLI::App& program, Action& chosen);
void addGolden(CLI::App& program, Action& chosen);
void addInfo(CLI::App& program, Action& chosen);
void addTrajectory(CLI::App& program, Action& chosen);
void addGrade(CLI::App& program, Action& chosen);
void addDiff(CLI::App& program, Action& chosen);
void addCheck(CLI::App& program, Action& chosen);
void addNew(CLI::App& program, Action& chosen);
void addPreview(CLI::App& program, Action& chosen);
void addExplain(CLI::App& program, Action& chosen);
void addSchema(CLI::App& program, Action& chosen);
void addDoctor(CLI::App& program, Action& chosen);
void addBackends(CLI::App& program, Action& chosen);
/// Hidden: the build makes man pages and completions with it.
void addSelfDescribe(CLI::App& program, Action& chosen);

/// Text of --version: the program, the libraries it runs with, what its binaries fall under.
std::string versionText();

}  // namespace poinsot::cli
