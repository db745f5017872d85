// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// Description of the command line, read back from the parser. Man pages and completions are made from this
/// description, so that a new option is declared only once.
namespace poinsot::cli {

/// Kind of a value on the command line, from which a shell completes it.
enum class WordKind { kOther, kFile, kFolder, kScene, kTable, kKey };

struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; empty for an operand
  std::string value;               ///< "FILE", or the name of an operand; empty for a flag
  std::string help;
  std::string range;               ///< "1 to 1024", or empty
  std::vector<std::string> words;  ///< all allowed values, if they are few
  WordKind kind = WordKind::kOther;
  bool required = false, repeats = false;
};

struct FileKeyText {
  std::string path, value, help;
};

struct CommandText {
  std::string name;  ///< empty for the program itself
  std::string summary;
  std::vector<std::string> notes, examples;
  std::vector<OptionText> options, operands;
  std::vector<FileKeyText> fileKeys;  ///< keys of golden's manifest; keys of scenes have their own page
};

struct KeyText {
  std::string path;
  std::vector<std::string> words;  ///< all allowed values, if they are few
};

struct ProgramText {
  std::string version;
  CommandText program;
  std::vector<CommandText> commands;  ///< commands that --help lists
  std::vector<KeyText> keys;
};

ProgramText textOf(const CLI::App& program);

/// Returns what the first argument can be: a name of a command, or "help".
std::vector<std::string> firstWords(const ProgramText& text);

/// Returns "key=" for all keys, and with `withValues` also "key=value" for keys with few values.
std::vector<std::string> assignments(const std::vector<KeyText>& keys, bool withValues);

}  // namespace poinsot::cli
