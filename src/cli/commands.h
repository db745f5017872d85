// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/command.h"

namespace poinsot::cli {

/// Each declares one command of the program with its options.
void addRender(const Command& program);
void addStill(const Command& program);
void addSweep(const Command& program);
void addGallery(const Command& program);
void addStatus(const Command& program);
void addAssemble(const Command& program);
void addSubmit(const Command& program);
void addGolden(const Command& program);
void addInfo(const Command& program);
void addTrajectory(const Command& program);
void addGrade(const Command& program);
void addDiff(const Command& program);
void addCheck(const Command& program);
void addNew(const Command& program);
void addPreview(const Command& program);
void addExplain(const Command& program);
void addSchema(const Command& program);
void addDoctor(const Command& program);
/// Hidden: the build makes man pages and completions with it.
void addSelfDescribe(const Command& program);

/// Text of --version: the program, the libraries it runs with, what its binaries fall under.
std::string versionText();

}  // namespace poinsot::cli
