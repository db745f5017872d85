// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

/// Every command that writes files, with every option that names one.
namespace poinsot {

using Words = std::vector<std::string>;

/// A file that a run writes.
struct Output {
  std::string option;  ///< names it; empty for a file beside the output of another option
  std::string value;   ///< of the option; `file` or its folder
  std::string file = value;
  bool isKnown = true;     ///< whether an earlier one is known as such, and replaced
  bool isAddedTo = false;  ///< whether text is added to what is there
  bool isAnyName = true;   ///< whether the option takes a file of any name
};

/// A command with all of its outputs, and what it reads.
struct OutputCommand {
  std::string name;
  Words words;
  std::vector<Output> outputs;
  Words inputs;
  Words before = {};        ///< a command that is run first
  int exitCode = 0;         ///< of a run that does its work
  std::string unlike = {};  ///< words that say which of several ways of the command this is
};

/// For the names of parametrised tests.
inline void PrintTo(const OutputCommand& command, std::ostream* out) { *out << command.name << command.unlike; }

const std::vector<OutputCommand>& outputCommands();

}  // namespace poinsot
