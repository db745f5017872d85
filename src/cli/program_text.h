// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// Description of the command line, generated from the parser. Man pages and completions use this description, so
/// that a new option is declared only once.
namespace poinsot::cli {

/// Kind of a value on the command line, which determines the words that a shell offers.
enum class WordKind { kOther, kFile, kFolder, kScene, kTable, kKey };

struct OptionText {
  std::vector<std::string> names;  ///< for example "-o" and "--output"; empty for an operand
  std::string value;               ///< name of the value, such as "FILE"; name of an operand; empty for a flag
  std::string help;
  std::string range;               ///< range such as "1 to 1024", or empty
  std::vector<std::string> words;  ///< allowed values; empty if any value is allowed
  WordKind kind = WordKind::kOther;
  bool required = false, repeats = false;
};

struct FileKeyText {
  std::string path, value, help;
};

struct CommandText {
  std::string name;  ///< name of the command; empty for the program itself
  std::string summary;
  std::vector<std::string> notes, examples;
  std::vector<OptionText> options, operands;
  std::vector<FileKeyText> fileKeys;  ///< keys of the command's file: golden.toml for `golden`, otherwise empty
};

struct KeyText {
  std::string path;
  std::vector<std::string> words;  ///< allowed values; empty if there are too many
};

struct ProgramText {
  std::string version;
  CommandText program;
  std::vector<CommandText> commands;  ///< commands listed by --help
  std::vector<KeyText> keys;
};

ProgramText textOf(const CLI::App& program);

/// Returns the words that can be the first argument: the names of the commands, and "help".
std::vector<std::string> firstWords(const ProgramText& text);

/// Returns "key=" for all keys. If `withValues`, also returns "key=value" for keys that have few values.
std::vector<std::string> assignments(const std::vector<KeyText>& keys, bool withValues);

}  // namespace poinsot::cli
