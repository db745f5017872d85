// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The command line as values: what was declared to the parser, read back from it. Man pages and completions are
/// written from this, so that a new option needs no second place.
namespace poinsot::cli {

/// What a word of the command line names, as far as a shell can help with it.
enum class WordKind { kOther, kFile, kFolder, kScene, kTable, kKey };

struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; empty for an operand
  std::string value;               ///< "FILE"; the name of an operand; empty for a flag
  std::string help;
  std::string range;               ///< "1 to 1024", or empty
  std::vector<std::string> words;  ///< the values there are, if they are few
  WordKind kind = WordKind::kOther;
  bool required = false, repeats = false;
};

/// A key of the file that a command reads.
struct FileKeyText {
  std::string path, value, help;
};

struct CommandText {
  std::string name;  ///< empty for the program itself
  std::string summary;
  std::vector<std::string> notes, examples;
  std::vector<OptionText> options, operands;
  std::vector<FileKeyText> fileKeys;  ///< of golden's manifest; keys of scenes have a page of their own
};

/// A key of scenes, for -D.
struct KeyText {
  std::string path;
  std::vector<std::string> words;  ///< the values there are, if they are few
};

struct ProgramText {
  std::string version;
  CommandText program;
  std::vector<CommandText> commands;  ///< those that --help lists
  std::vector<KeyText> keys;
};

ProgramText textOf(const CLI::App& program);

/// Names of the commands and "help": what the first word can be.
std::vector<std::string> firstWords(const ProgramText& text);

/// "key=" for all keys, and "key=value" for those with few values where `withValues`.
std::vector<std::string> assignments(const std::vector<KeyText>& keys, bool withValues);

}  // namespace poinsot::cli
