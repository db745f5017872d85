// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/completion.h"
#include "core/shell_word.h"

namespace poinsot::cli {
namespace {

/// Helper functions for bash. Bash splits words at "=", so "-D key=v" is four words. The functions do not need the
/// package bash-completion.
constexpr const char* kHelpers = R"(
_poinsot_words() { mapfile -t COMPREPLY < <(compgen -W "$*" -- "$word"); }

_poinsot_files() { # of any of the patterns, and folders
  local pattern
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -d -- "$word"; for pattern; do compgen -f -X "!$pattern" -- "$word"; done)
}

_poinsot_folders() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
}
)";

constexpr const char* kWords = R"(
_poinsot() {
  local word=${COMP_WORDS[COMP_CWORD]} left=$((COMP_CWORD - 1)) assigned= key=
  COMPREPLY=()
  if [[ $word == = ]]; then
    word= assigned=1
  elif [[ ${COMP_WORDS[left]} == = ]]; then
    left=$((left - 1)) assigned=1
  fi
  local option=${COMP_WORDS[left]}
  if [[ $assigned && ${COMP_WORDS[left - 1]} == -D ]]; then key=$option option=-D; fi
)";

std::string wordsCall(const std::vector<std::string>& words) {
  return "_poinsot_words " + core::shellWords(words);
}

std::string patternOf(WordKind kind) {
  if (kind == WordKind::kScene) return "'*.toml'";
  return kind == WordKind::kTable ? "'*.csv'" : "'*'";
}

std::string offer(const OptionText& option) {
  if (!option.words.empty()) return wordsCall(option.words);
  switch (option.kind) {
    case WordKind::kFile:
    case WordKind::kScene:
    case WordKind::kTable:
      return "_poinsot_files " + patternOf(option.kind);
    case WordKind::kFolder:
      return "_poinsot_folders";
    case WordKind::kKey:
      return "_poinsot_key";
    case WordKind::kOther:
      break;
  }
  return ":";
}

std::string keyFunction(const std::vector<KeyText>& keys) {
  std::string cases;
  for (const KeyText& key : keys)
    if (!key.words.empty()) cases += fmt::format("    {}) {} ;;\n", key.path, wordsCall(key.words));
  return fmt::format(
      "\n_poinsot_key() {{ # keys of a scene; after the =, values\n"
      "  case $key in\n"
      "    '') compopt -o nospace; {} ;;\n{}"
      "  esac\n}}\n",
      wordsCall(assignments(keys, false)), cases);
}

std::string branch(const CommandText& command, const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += fmt::format("{}'{} {}'", names.empty() ? "" : " | ", command.name, name);
  return fmt::format("    {}) {}; return ;;\n", names, offer(option));
}

std::string valueBranches(const ProgramText& text) {
  std::string branches;
  for (const CommandText& command : text.commands)
    for (const OptionText& option : command.options)
      if (!option.value.empty()) branches += branch(command, option);
  return branches;
}

std::vector<std::string> optionNames(const CommandText& command) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::string optionBranches(const ProgramText& text) {
  std::string branches;
  for (const CommandText& command : text.commands)
    branches += fmt::format("      {}) {} ;;\n", command.name, wordsCall(optionNames(command)));
  return branches;
}

std::string operandOffer(const CommandText& command) {
  std::string patterns;
  for (const OptionText& operand : command.operands) patterns += " " + patternOf(operand.kind);
  return patterns.empty() ? ":" : "_poinsot_files" + patterns;
}

std::string operandBranches(const ProgramText& text) {
  std::string branches;
  for (const CommandText& command : text.commands)
    branches += fmt::format("      {}) {} ;;\n", command.name, operandOffer(command));
  return branches;
}

}  // namespace

std::string bashCompletion(const ProgramText& text) {
  auto first = firstWords(text);
  const std::string help = wordsCall(first);
  for (const std::string& name : optionNames(text.program)) first.push_back(name);
  return fmt::format("# Completion of poinsot {} for bash; written by the program itself.\n", text.version) +
         kHelpers + keyFunction(text.keys) + kWords +
         fmt::format(
             "  if ((COMP_CWORD == 1)); then {}; return; fi\n"
             "  case \"${{COMP_WORDS[1]}} $option\" in\n"
             "    'help '*) ((COMP_CWORD > 2)) || {}; return ;;\n"
             "{}  esac\n"
             "  if [[ $word == -* ]]; then\n"
             "    case ${{COMP_WORDS[1]}} in\n{}    esac\n"
             "  else\n"
             "    case ${{COMP_WORDS[1]}} in\n{}    esac\n"
             "  fi\n}}\n\ncomplete -F _poinsot poinsot\n",
             wordsCall(first), help, valueBranches(text), optionBranches(text), operandBranches(text));
}

}  // namespace poinsot::cli
