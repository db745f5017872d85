// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/command.h"

namespace poinsot::cli {

/// Declarations of the commands, each with its options.
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
/// Declares a hidden command that writes man pages and shell completions, for the build.
void addSelfDescribe(const Command& program);

/// Returns the text of --version: the versions of poinsot and its libraries, and the licences of the binaries.
std::string versionText();

}  // namespace poinsot::cli
