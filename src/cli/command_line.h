// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"

namespace poinsot::cli {

/// Parsed arguments of the program. The constructor reads no files, prints nothing and starts no work.
class CommandLine {
 public:
  /// @throws core::Error(kUsage).
  explicit CommandLine(std::vector<std::string> words);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Runs the command, in a sandbox if --untrusted is given.
  /// @returns the exit code. @throws the command's exception
  int run() const;

 private:
  std::unique_ptr<CLI::App> program_;  ///< the parser; kept because actions may refer to it
  Action chosen_;
};

}  // namespace poinsot::cli
