// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"

namespace poinsot::cli {

/// The words after the program's name, understood. Nothing is done, read or printed before run().
class CommandLine {
 public:
  /// @throws core::Error(kUsage).
  explicit CommandLine(std::vector<std::string> words);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Does what they ask for; with --untrusted in a sandbox. @returns the exit code. @throws whatever the command
  /// throws.
  int run() const;

 private:
  std::unique_ptr<CLI::App> program_;  ///< which actions may refer to
  Action chosen_;
};

}  // namespace poinsot::cli
