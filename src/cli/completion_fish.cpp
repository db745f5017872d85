// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/completion.h"
#include "core/text.h"

namespace poinsot::cli {
namespace {

/// Quotes a word for fish. In single quotes, only two characters need a backslash.
std::string fishWord(const std::string& text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') word += '\\';
    word += c;
  }
  return word + "'";
}

std::string complete(const std::string& command, const std::string& rest) {
  const std::string when = command.empty() ? "__poinsot_has_no_command" : "__poinsot_command_is " + command;
  return fmt::format("complete -c poinsot -n {} {}\n", fishWord(when), rest);
}

/// Returns the arguments of fish's `complete` that offer the values of an option, or files if the value is a file.
std::string fishOffer(const OptionText& option) {
  if (!option.words.empty()) return "-x -a " + fishWord(core::joined(option.words, " "));
  switch (option.kind) {
    case WordKind::kFile:
      return "-r -F";
    case WordKind::kFolder:
      return "-x -a '(__fish_complete_directories)'";
    case WordKind::kScene:
      return "-k -x -a '(__fish_complete_suffix .toml)'";
    case WordKind::kTable:
      return "-k -x -a '(__fish_complete_suffix .csv)'";
    case WordKind::kKey:
      return "-x -a '(__poinsot_keys)'";
    case WordKind::kOther:
      break;
  }
  return "-x";
}

std::string optionLine(const CommandText& command, const OptionText& option) {
  std::string rest;
  for (const std::string& name : option.names)
    rest += name.starts_with("--") ? "-l " + name.substr(2) + " " : "-s " + name.substr(1) + " ";
  if (!option.value.empty()) rest += fishOffer(option) + " ";
  return complete(command.name, rest + "-d " + fishWord(option.help));
}

/// Returns the line that completes an operand. fish treats all operands of a command alike.
std::string operandLine(const CommandText& command, const OptionText& operand) {
  const bool any = operand.kind == WordKind::kFile;
  return complete(command.name, any ? "-F" : fishOffer(operand));
}

std::string commandLines(const CommandText& command) {
  std::string lines = complete("", fmt::format("-a {} -d {}", command.name, fishWord(command.summary)));
  for (const OptionText& option : command.options) lines += optionLine(command, option);
  for (const OptionText& operand : command.operands) lines += operandLine(command, operand);
  return lines;
}

std::string functions(const ProgramText& text) {
  std::string keys;
  for (const std::string& word : assignments(text.keys, true)) keys += " " + fishWord(word);
  return fmt::format(
      "function __poinsot_has_no_command\n"
      "    test (count (commandline -opc)) -eq 1\n"
      "end\n\n"
      "function __poinsot_command_is\n"
      "    set -l words (commandline -opc)\n"
      "    test (count $words) -gt 1; and test $words[2] = $argv[1]\n"
      "end\n\n"
      "function __poinsot_keys # of a scene, with the values of those that have few\n"
      "    string join \\n{}\n"
      "end\n\n",
      keys);
}

}  // namespace

std::string fishCompletion(const ProgramText& text) {
  std::string script =
      fmt::format("# Completion of poinsot {} for fish; written by the program itself.\n\n", text.version) +
      functions(text) + "complete -c poinsot -f\n" + complete("", "-a help -d 'show the help of a command'");
  for (const OptionText& option : text.program.options) script += optionLine(text.program, option);
  std::string names;
  for (const CommandText& command : text.commands) {
    script += commandLines(command);
    names += (names.empty() ? "" : " ") + command.name;
  }
  return script + complete("help", "-a " + fishWord(names));
}

}  // namespace poinsot::cli
