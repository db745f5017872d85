// SPDX-License-Identifier: Apache-2.0
#include "cli/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cli/exit_code.h"
#include "cli/variables.h"
#include "core/text.h"

namespace poinsot::cli {
namespace {

/// Escapes characters that roff would interpret or replace.
std::string escaped(const std::string& text) {
  std::string roff;
  for (const char c : text) switch (c) {
      case '\\':
        roff += "\\e";
        break;
      case '-':
        roff += "\\-";
        break;
      case '\'':
        roff += "\\(aq";
        break;
      case '`':
        roff += "\\(ga";
        break;
      case '^':
        roff += "\\(ha";
        break;
      case '~':
        roff += "\\(ti";
        break;
      default:
        roff += c;
    }
  return roff.starts_with('.') ? "\\&" + roff : roff;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string nameOf(const CommandText& command) {
  return command.name.empty() ? "poinsot" : "poinsot-" + command.name;
}

std::string title(const ProgramText& text, const CommandText& command) {
  std::string upper = nameOf(command);
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return fmt::format(".TH {} 1 \"\" \"poinsot {}\" \"poinsot\"\n", escaped(upper), text.version);
}

std::string operandsLine(const CommandText& command) {
  std::string line = command.name.empty() ? " " + italic("COMMAND") : "";
  for (const OptionText& operand : command.operands) {
    const std::string word = italic(operand.value) + (operand.repeats ? "..." : "");
    line += operand.required ? " " + word : " [" + word + "]";
  }
  return line;
}

std::string synopsis(const CommandText& command) {
  const std::string words = command.name.empty() ? "poinsot" : "poinsot " + command.name;
  return fmt::format(".SH SYNOPSIS\n{}{} [{}]...\n", bold(words), operandsLine(command), italic("OPTION"));
}

std::string entry(const std::string& what, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", what, text);
}

/// Returns the allowed values in parentheses. Returns an empty text if the help already names them.
std::string allowed(const OptionText& option) {
  const auto told = [&](const std::string& word) { return option.help.find(word) != std::string::npos; };
  if (!option.range.empty()) return fmt::format(" ({})", option.range);
  return std::ranges::all_of(option.words, told) ? "" : fmt::format(" ({})", core::joined(option.words, ", "));
}

std::string optionEntry(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
  if (!option.value.empty()) names += (names.empty() ? "" : " ") + italic(option.value);
  return entry(names, escaped(option.help + allowed(option)));
}

std::string optionList(const char* heading, const std::vector<OptionText>& options) {
  std::string text;
  for (const OptionText& option : options) text += optionEntry(option);
  return text.empty() ? "" : fmt::format(".SH {}\n{}", heading, text);
}

std::string fileKeyList(const CommandText& command) {
  std::string text;
  for (const FileKeyText& key : command.fileKeys)
    text += entry(bold(key.path) + " " + italic(key.value), escaped(key.help));
  return text.empty() ? "" : ".SH KEYS OF MANIFEST\n" + text;
}

std::string commandList(const ProgramText& text) {
  std::string list = ".SH COMMANDS\n";
  for (const CommandText& command : text.commands)
    list += entry(bold(nameOf(command)) + "(1)", escaped(command.summary));
  return list;
}

std::string variableList() {
  std::string list = ".SH ENVIRONMENT\n";
  for (const Variable& variable : variables()) list += entry(bold(variable.name), escaped(variable.help));
  return list;
}

std::string notes(const CommandText& command) {
  if (command.name.empty() || command.notes.empty()) return "";  // exitStatus() prints the program's notes
  std::string text = ".SH NOTES\n";
  for (const std::string& line : command.notes) text += escaped(line) + "\n";
  return text;
}

std::string examples(const CommandText& command) {
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (const std::string& line : command.examples) text += escaped(line) + "\n";
  return text + ".fi\n";
}

std::string seeAlso(const ProgramText& text, const CommandText& command) {
  if (!command.name.empty()) return ".SH SEE ALSO\n" + bold("poinsot") + "(1)\n";
  std::string list;
  for (const CommandText& other : text.commands) list += (list.empty() ? "" : ",\n") + bold(nameOf(other)) + "(1)";
  return ".SH SEE ALSO\n" + list + "\n";
}

/// Returns the section on exit codes. Removes the indentation of the help's lines, because roff formats them anew.
std::string exitStatus() {
  std::string text = kExitCodesText;
  for (auto at = text.find("\n "); at != std::string::npos; at = text.find("\n ")) text.erase(at + 1, 1);
  return ".SH EXIT STATUS\n" + escaped(text) + "\n";
}

}  // namespace

std::string manPageName(const CommandText& command) { return nameOf(command) + ".1"; }

std::string manPage(const ProgramText& text, const CommandText& command) {
  std::string summary = command.summary;
  if (summary.ends_with('.')) summary.pop_back();
  return title(text, command) + fmt::format(".SH NAME\n{} \\- {}\n", escaped(nameOf(command)), escaped(summary)) +
         synopsis(command) + (command.name.empty() ? commandList(text) : "") +
         optionList("OPERANDS", command.operands) + optionList("OPTIONS", command.options) + fileKeyList(command) +
         notes(command) + examples(command) + exitStatus() + (command.name.empty() ? variableList() : "") +
         seeAlso(text, command);
}

}  // namespace poinsot::cli
