// SPDX-License-Identifier: Apache-2.0
#include "suite/explanation.h"

#include <fmt/format.h>

namespace poinsot::suite {
namespace {

using scene::Explanation;

struct Table {
  const char* name;  ///< GoldenKey::table of the table's keys
  const char* path;
  const char* title;  ///< heading of the table in a manifest
  const char* help;
};

constexpr Table kTables[] = {
    {"", "golden", "golden.toml", "The pictures that poinsot golden makes and compares."},
    {"test", "golden.test", "[[test]]",
     "Pictures of a scene, or images that other programs made. At least one table."},
    {"rule", "golden.rule", "[rule]",
     "How far pictures may be from their references: [rule] for all tests, [test.rule] for one."},
};

const Table& tableOf(const GoldenKey& key) {
  for (const Table& table : kTables)
    if (std::string_view(table.name) == key.table) return table;
  return kTables[0];
}

/// Strips brackets and prefixes. Returns "rule.max" for "[test.rule.max]", "golden.test.rule.max" and
/// "golden.toml.rule.max".
std::string_view plainPath(std::string_view word) {
  while (word.size() > 1 && word.starts_with('[') && word.ends_with(']')) word = word.substr(1, word.size() - 2);
  if (word == "golden.toml") return "golden";
  for (const std::string_view prefix : {"golden.toml.", "golden."})
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  if (word.starts_with("test.rule.")) word.remove_prefix(5);
  return word;
}

Explanation ofKey(const GoldenKey& key) {
  Explanation explanation{pathOf(key), key.help, {{"takes", key.value}}};
  explanation.rows.push_back({"default", *key.fallback ? key.fallback : "none"});
  const std::string header = *key.table ? std::string(tableOf(key).title) + '\n' : "";
  explanation.rows.push_back(
      {"example", *key.example ? fmt::format("{}{} = {}", header, key.name, key.example) : key.value});
  return explanation;
}

Explanation ofTable(const Table& table) {
  Explanation explanation{
      *table.name ? fmt::format("{} of golden.toml", table.title) : table.title, table.help, {}};
  for (const GoldenKey& key : goldenKeys())
    if (std::string_view(table.name) == key.table) explanation.rows.push_back({key.name, key.help});
  return explanation;
}

std::string markdownCell(std::string_view text) {
  std::string cell;
  for (const char c : text) cell += c == '|' || c == '*' ? std::string{'\\', c} : std::string{c};
  return cell;
}

/// Returns a form such as "[width, height]" in backticks. Returns a description in words unchanged.
std::string markdownForm(std::string_view value) {
  const bool isForm = value.find_first_of("[\"=") != std::string_view::npos;
  return isForm ? fmt::format("`{}`", value) : std::string(value);
}

}  // namespace

std::string pathInFile(const GoldenKey& key) {
  return *key.table ? fmt::format("{}.{}", key.table, key.name) : key.name;
}

std::string pathOf(const GoldenKey& key) { return "golden." + pathInFile(key); }

std::vector<Explanation> explainGolden(std::string_view word) {
  const std::string_view path = plainPath(word);
  std::vector<Explanation> found;
  for (const Table& table : kTables) {
    const std::string_view own = *table.name ? table.name : "golden";
    if (path == own || (own == "rule" && path == "test.rule")) found.push_back(ofTable(table));
  }
  const bool isWhole = word != path;  // a full path does not match a key's bare name
  for (const GoldenKey& key : goldenKeys()) {
    if (pathInFile(key) == path || (key.name == path && !isWhole)) found.push_back(ofKey(key));
  }
  return found;
}

std::vector<std::string> goldenWords() {
  std::vector<std::string> words;
  for (const Table& table : kTables) words.emplace_back(table.path);
  for (const GoldenKey& key : goldenKeys()) {
    words.push_back(pathOf(key));
    words.emplace_back(key.name);
  }
  return words;
}

std::string goldenKeysMarkdown() {
  std::string text;
  for (const Table& table : kTables) {
    text += fmt::format("\n`{}`: {}\n\n| key | takes | default | meaning |\n| --- | --- | --- | --- |\n",
                        table.title, table.help);
    for (const GoldenKey& key : goldenKeys())
      if (std::string_view(table.name) == key.table)
        text += fmt::format("| `{}` | {} | {} | {} |\n", key.name, markdownForm(key.value),
                            markdownCell(key.fallback), markdownCell(key.help));
  }
  return text + "\n";
}

}  // namespace poinsot::suite
