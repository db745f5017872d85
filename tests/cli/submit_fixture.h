// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "support/program_run.h"
#include "support/shell_run.h"

namespace poinsot {

inline constexpr const char* kHostile = "a film's $HOME `id` {} #1 \"100%A\"\n!";

/// Command that prints a script for the scene in the folder of Submit.
inline constexpr const char* kPrint = POINSOT_PROGRAM " submit ./-it\\'s.toml ";

/// Fixture with a folder that has a difficult name, a scene in it, and stand-ins for Slurm and for the program
/// beside it.
class Submit : public testing::Test {
 protected:
  Submit() {
    std::filesystem::create_directory(home());
    std::ofstream(home() / "-it's.toml") << kGoodScene;
  }

  std::filesystem::path home() const { return scratch_ / kHostile; }

  void executable(const std::string& name, const std::string& script) const {
    scratch_.put(name, "#!/bin/bash\n" + script);
    std::filesystem::permissions(scratch_ / name, std::filesystem::perms::owner_all);
  }

  /// Runs commands in the folder; the stand-ins are first on the PATH.
  /// @param environment  added to the environment of this process
  ShellResult shell(const std::string& script, const std::vector<std::string>& environment) const {
    return runShell(home(), "PATH=" + scratch_.path().string() + ":$PATH\n" + script, environment);
  }

  /// Runs commands with the stand-in for the program.
  ShellResult shell(const std::string& script) const {
    return shell(script, {"POINSOT=" + (scratch_ / "poinsot").string()});
  }

  /// Returns the lines that a stand-in has left; empty if it was not called.
  std::string left(const std::string& name) const {
    if (!std::filesystem::exists(scratch_ / name)) return "";
    const std::string text = bytesOf(scratch_ / name);
    std::filesystem::remove(scratch_ / name);
    return text;
  }

  ScratchFolder scratch_;
};

}  // namespace poinsot
