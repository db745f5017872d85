// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/completion.h"
#include "core/shell_word.h"
#include "core/text.h"

namespace poinsot::cli {
namespace {

/// Escapes text for the zsh functions _arguments and _describe, which use : and [ ] as separators.
std::string specText(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string zshOffer(const OptionText& option) {
  if (!option.words.empty()) return fmt::format("({})", core::joined(option.words, " "));
  switch (option.kind) {
    case WordKind::kFile:
      return "_files";
    case WordKind::kFolder:
      return "_files -/";
    case WordKind::kScene:
      return "_files -g \"*.toml\"";
    case WordKind::kTable:
      return "_files -g \"*.csv\"";
    case WordKind::kKey:
      return "_poinsot_key";
    case WordKind::kOther:
      break;
  }
  return " ";  // zsh shows the name of the value and offers no words
}

/// Returns zsh's mark for how an option takes its value. "+" (-o): in the same word or the next. "=" (--output):
/// after an equals sign or in the next word.
std::string valueSign(const std::string& name) { return name.starts_with("--") ? "=" : "+"; }

std::vector<std::string> optionSpecs(const OptionText& option) {
  std::vector<std::string> specs;
  const std::string others = option.repeats ? "*" : fmt::format("({})", core::joined(option.names, " "));
  for (const std::string& name : option.names) {
    std::string spec = others + name;
    if (!option.value.empty()) spec += valueSign(name);
    spec += fmt::format("[{}]", specText(option.help));
    if (!option.value.empty()) spec += fmt::format(":{}:{}", specText(option.value), zshOffer(option));
    specs.push_back(spec);
  }
  return specs;
}

std::string operandSpec(const OptionText& operand) {
  return fmt::format("{}:{}:{}",
                     operand.repeats    ? "*"
                     : operand.required ? ""
                                        : ":",
                     specText(operand.value), zshOffer(operand));
}

std::string arguments(const CommandText& command) {
  std::string call = "_arguments -s -S";
  for (const OptionText& option : command.options)
    for (const std::string& spec : optionSpecs(option)) call += " \\\n        " + core::shellWord(spec);
  for (const OptionText& operand : command.operands)
    call += " \\\n        " + core::shellWord(operandSpec(operand));
  return call;
}

std::string zshKeyFunction(const std::vector<KeyText>& keys) {
  std::string cases;
  for (const KeyText& key : keys)
    if (!key.words.empty())
      cases += fmt::format("      {}) compadd -- {} ;;\n", key.path, core::shellWords(key.words));
  std::string paths;
  for (const KeyText& key : keys) paths += " " + key.path;
  return fmt::format(
      "_poinsot_key() {{ # keys of a scene; after the =, values\n"
      "  local key=${{PREFIX%%=*}}\n"
      "  if compset -P '*='; then\n"
      "    case $key in\n{}    esac\n"
      "  else\n"
      "    compadd -S = --{}\n"
      "  fi\n}}\n\n",
      cases, paths);
}

std::string zshCommandList(const ProgramText& text) {
  std::string list = "    " + core::shellWord("help:show the help of a command") + "\n";
  for (const CommandText& command : text.commands)
    list += "    " + core::shellWord(command.name + ":" + specText(command.summary)) + "\n";
  return list;
}

std::string commandCases(const ProgramText& text) {
  std::string cases;
  for (const CommandText& command : text.commands)
    cases += fmt::format("      {})\n        {} ;;\n", command.name, arguments(command));
  return cases;
}

}  // namespace

std::string zshCompletion(const ProgramText& text) {
  return fmt::format(
      "#compdef poinsot\n"
      "# Completion of poinsot {} for zsh; written by the program itself.\n\n"
      "{}"
      "_poinsot() {{\n"
      "  local curcontext=$curcontext state line\n"
      "  local -A opt_args\n"
      "  local -a commands=(\n{}  )\n"
      "  _arguments -C '--version[versions of the program and its libraries]' '(-h --help)'{{-h,--help}}'[help]' "
      "\\\n"
      "    '1: :->command' '*:: :->rest' && return\n"
      "  case $state in\n"
      "    command) _describe command commands ;;\n"
      "    rest)\n"
      "      case $words[1] in\n"
      "      help) (( CURRENT == 2 )) && _describe command commands ;;\n"
      "{}      esac ;;\n"
      "  esac\n}}\n\n"
      "if [[ $zsh_eval_context[-1] == loadautofunc ]]; then _poinsot \"$@\"; else compdef _poinsot poinsot; fi\n",
      text.version, zshKeyFunction(text.keys), zshCommandList(text), commandCases(text));
}

}  // namespace poinsot::cli
