// SPDX-License-Identifier: Apache-2.0
#include "cli/program_text.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "core/version.h"
#include "scene/keys/keys.h"
#include "suite/explanation.h"

namespace poinsot::cli {
namespace {

struct KindOfWord {
  std::string_view value;
  WordKind kind;
};

constexpr KindOfWord kKinds[] = {
    {"FILE", WordKind::kFile},    {"FOLDER", WordKind::kFolder}, {"SCENE", WordKind::kScene},
    {"THEIRS", WordKind::kTable}, {"OUTPUT", WordKind::kFile},   {"KEY=VALUE", WordKind::kKey},
};

/// Returns the kind of a value, judged by the name of the value. An operand with another name counts as a file,
/// because files are all that a shell can offer.
WordKind kindOf(const OptionText& option) {
  const auto* known = std::ranges::find(kKinds, option.value, &KindOfWord::value);
  if (known != std::end(kKinds)) return known->kind;
  return option.names.empty() ? WordKind::kFile : WordKind::kOther;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

std::string within(const std::string& text, char open, char close) {
  const auto from = text.find(open), to = text.rfind(close);
  return from == std::string::npos || to == std::string::npos ? "" : text.substr(from + 1, to - from - 1);
}

/// Parses CLI11's description of a value, such as "NAME:{auto,osmesa,egl}" or "N:INT in [1 - 1024]".
void readValue(const std::string& typeName, OptionText& option) {
  const auto colon = typeName.find(':');
  option.value = typeName.substr(0, colon);
  if (colon == std::string::npos) return;
  const std::string allowed = typeName.substr(colon + 1);
  option.words = split(within(allowed, '{', '}'), ',');
  option.range = within(allowed, '[', ']');
  if (const auto dash = option.range.find(" - "); dash != std::string::npos) option.range.replace(dash, 3, " to ");
}

OptionText optionText(const CLI::Option& declared) {
  OptionText option;
  for (const std::string& name : declared.get_snames()) option.names.push_back("-" + name);
  for (const std::string& name : declared.get_lnames()) option.names.push_back("--" + name);
  if (declared.get_items_expected_max() > 0) readValue(declared.get_type_name(), option);
  if (declared.get_positional()) option.value = declared.get_name(true);
  option.help = declared.get_description();
  option.kind = kindOf(option);
  option.required = declared.get_required();
  option.repeats = declared.get_items_expected_max() > 1 ||
                   declared.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return option;
}

/// Splits the text at the end of the help into notes and examples. Examples are the indented lines after
/// "Example:" or "Examples:".
void readFooter(const std::string& footer, CommandText& command) {
  bool inExamples = false;
  for (const std::string& line : split(footer, '\n')) {
    const bool indented = line.starts_with("  ");
    if (line.starts_with("Example"))
      inExamples = true;
    else if (inExamples && indented)
      command.examples.push_back(line.substr(2));
    else {
      inExamples = false;
      command.notes.push_back(indented ? line.substr(2) : line);
    }
  }
}

std::vector<FileKeyText> goldenKeyTexts() {
  std::vector<FileKeyText> texts;
  for (const suite::GoldenKey& key : suite::goldenKeys()) {
    const std::string fallback = *key.fallback ? std::string(" (default: ") + key.fallback + ")" : "";
    texts.push_back({suite::pathInFile(key), key.value, key.help + fallback});
  }
  return texts;
}

CommandText commandText(const CLI::App& declared) {
  CommandText command;
  command.name = declared.get_parent() ? declared.get_name() : "";
  command.summary = declared.get_description();
  readFooter(declared.get_footer(), command);
  if (command.name == "golden") command.fileKeys = goldenKeyTexts();
  for (const CLI::Option* option : declared.get_options())
    (option->get_positional() ? command.operands : command.options).push_back(optionText(*option));
  return command;
}

/// Returns all keys of scenes except those in arrays, which can only be set in the file.
std::vector<KeyText> keyTexts() {
  std::vector<KeyText> texts;
  for (const scene::Key& key : scene::keys()) {
    if (key.path.find("[]") != std::string::npos) continue;
    texts.push_back({key.path, {key.words.begin(), key.words.end()}});
    if (key.type == scene::ValueType::kBool) texts.back().words = {"true", "false"};
  }
  std::ranges::sort(texts, {}, &KeyText::path);
  return texts;
}

}  // namespace

ProgramText textOf(const CLI::App& program) {
  ProgramText text{core::version(), commandText(program), {}, keyTexts()};
  for (const CLI::App* command :
       program.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); }))
    text.commands.push_back(commandText(*command));
  return text;
}

std::vector<std::string> firstWords(const ProgramText& text) {
  std::vector<std::string> words{"help"};
  for (const CommandText& command : text.commands) words.push_back(command.name);
  return words;
}

std::vector<std::string> assignments(const std::vector<KeyText>& keys, bool withValues) {
  std::vector<std::string> words;
  for (const KeyText& key : keys) {
    words.push_back(key.path + "=");
    if (withValues)
      for (const std::string& value : key.words) words.push_back(key.path + "=" + value);
  }
  return words;
}

}  // namespace poinsot::cli
