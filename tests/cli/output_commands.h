// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

/// Every command that writes files, with every option that names a file.
namespace poinsot {

using Words = std::vector<std::string>;

struct Output {
  std::string option;  ///< option that names the file; empty for a file beside the output of another option
  std::string value;   ///< argument of the option: `file` or its folder
  std::string file = value;
  bool isKnown = true;     ///< whether the program recognises its earlier file and replaces it
  bool isAddedTo = false;  ///< whether text is appended to an existing file
  bool isAnyName = true;   ///< whether the option accepts any file name
};

struct OutputCommand {
  std::string name;
  Words words;
  std::vector<Output> outputs;
  Words inputs;
  Words before = {};        ///< command to run first
  int exitCode = 0;         ///< exit code of a successful run
  std::string unlike = {};  ///< distinguishes several forms of the command in test names
};

inline void PrintTo(const OutputCommand& command, std::ostream* out) { *out << command.name << command.unlike; }

const std::vector<OutputCommand>& outputCommands();

}  // namespace poinsot
