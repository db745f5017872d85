// SPDX-License-Identifier: Apache-2.0
#include "pasting.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "core/text.h"
#include "scene/keys/keys.h"

namespace poinsot::scene {
namespace {

using TextLines = std::vector<std::string>;

TextLines textLines(const std::string& text) {
  std::istringstream in(text);
  TextLines lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool says(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

/// Returns the words of a list such as "a, b and c".
TextLines listedIn(std::string text) {
  for (std::size_t at = text.find(" and "); at != std::string::npos; at = text.find(" and "))
    text.replace(at, 5, ", ");
  std::istringstream in(text);
  TextLines names;
  for (std::string name; std::getline(in >> std::ws, name, ',');) names.push_back(name);
  return names;
}

std::string textBetween(const std::string& text, const std::string& begin, const std::string& ends) {
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return "";
  const std::string rest = text.substr(at + begin.size());
  return rest.substr(0, rest.find_first_of(ends));
}

/// TextLines of an example, and the sentence that says where they belong.
struct Block {
  std::string where;
  TextLines lines;
};

std::vector<Block> blocksOf(const std::string& message) {
  std::vector<Block> blocks;
  const std::size_t begin = message.find(" For example");
  if (begin == std::string::npos) return blocks;
  for (const std::string& line : textLines(message.substr(begin)))
    if (line.starts_with("    "))
      blocks.back().lines.push_back(line.substr(4));
    else if (line.starts_with(" For example") || line.starts_with("  and"))
      blocks.push_back({line, {}});
    else
      break;  // another way, of which the example is not part
  return blocks;
}

bool isSyntax(const Problem& problem) {
  return says(problem.message, "not TOML") || says(problem.message, "not a TOML");
}

/// Text of a scene, whose lines keep the numbers of the original.
class Editor {
 public:
  explicit Editor(const std::string& text) {
    int number = 0;
    for (const std::string& line : textLines(text)) lines_.push_back({++number, line});
  }

  void apply(const Problem& problem) {
    const std::string& message = problem.message;
    const std::vector<Block> blocks = blocksOf(message);
    std::size_t at = indexOf(problem.where.line);
    if (isSyntax(problem) && at == lines_.size()) return;  // the line is mended already
    const std::size_t table = tableAround(at).first;
    isSyntax_ = isSyntax(problem);
    number_ = problem.where.line;
    const bool leaves =
        says(message, "leave it out") || says(message, "leave them out") || says(message, "leave this line out");
    if (says(message, "got a table. For example, in place of ["))
      lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(at));
    else if (says(message, "in place of this [["))
      at = removeTable(at);
    else if (says(message, "in place of [["))
      at = removeAll(textBetween(message, "in place of ", ":,"));
    else if (isSyntax(problem))
      lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(at));
    else if ((!blocks.empty() || leaves) && !says(message, " missing"))
      for (const std::string& name : listedIn(message.substr(0, message.find(':'))))
        removeKey(table, std::string(nameOf(name)), at);
    if (!blocks.empty())
      for (const std::string& name : listedIn(textBetween(blocks[0].where, "in place of ", ":")))
        if (name.find_first_of("[ ") == std::string::npos) removeKey(table, name, at);
    for (const Block& block : blocks) insert(at, block);
    removeEmptyTables();
  }

  std::string text() const {
    std::string text;
    for (const Line& line : lines_) text += line.text + "\n";
    return text;
  }

 private:
  struct Line {
    int number = 0;
    std::string text;
  };

  static bool isHeader(const Line& line) { return core::trimmed(line.text).starts_with('['); }

  static bool gives(const Line& line, const std::string& name) {
    const std::string_view text = core::trimmed(line.text);
    if (!text.starts_with(name) || text.size() == name.size()) return false;
    return text[name.size()] == ' ' || text[name.size()] == '=' || text[name.size()] == '.';
  }

  std::size_t indexOf(int number) const {
    const auto found = std::ranges::find(lines_, number, &Line::number);
    return static_cast<std::size_t>(found - lines_.begin());
  }

  /// Returns the first line and the end of the table that contains a line.
  std::pair<std::size_t, std::size_t> tableAround(std::size_t at) const {
    std::size_t begin = std::min(at, lines_.size());
    while (begin > 0 && !(begin < lines_.size() && isHeader(lines_[begin]))) --begin;
    std::size_t end = begin + 1;
    while (end < lines_.size() && !isHeader(lines_[end])) ++end;
    return {begin, std::min(end, lines_.size())};
  }

  std::size_t removeTable(std::size_t at) {
    const auto [begin, end] = tableAround(at);
    const auto first = lines_.begin();
    lines_.erase(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end));
    return begin;
  }

  std::size_t removeAll(const std::string& header) {
    std::size_t at = lines_.size();
    for (std::size_t i = lines_.size(); i-- > 0;)
      if (core::trimmed(lines_[i].text) == header) at = removeTable(i);
    return at;
  }

  /// Removes tables of the original scene in which nothing is left.
  void removeEmptyTables() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!isHeader(lines_[i]) || lines_[i].number == 0) continue;
      std::size_t end = i + 1;
      while (end < lines_.size() && core::trimmed(lines_[end].text).empty()) ++end;
      if (end == lines_.size() || isHeader(lines_[end])) removeTable(i--);
    }
  }

  /// Removes a key from the table that contains a line.
  /// @param at  receives the place of the key
  bool removeKey(std::size_t table, const std::string& name, std::size_t& at) {
    const auto [begin, end] = tableAround(table);
    for (std::size_t i = begin; i < end; ++i)
      if (gives(lines_[i], name)) {
        lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(i));
        at = i;
        return true;
      }
    return false;
  }

  std::size_t behindHeader(const std::string& header) {
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (core::trimmed(lines_[i].text) == header) return i + 1;
    lines_.push_back({0, header});
    return lines_.size();
  }

  void insert(std::size_t at, Block block) {
    if (says(block.where, "one of:")) {  // the first is the likeliest
      const std::string table = textBetween(block.lines[0], "# in ", ":");
      block = {table.starts_with("[[") ? "" : "in " + table + ":", {block.lines[0]}};
    }
    const std::size_t header = block.where.find("in [");
    const bool atEnd = says(block.where, "at the end of the file");
    if (header != std::string::npos)
      at = behindHeader(block.where.substr(header + 3, block.where.find(']', header) - header - 2));
    else if (atEnd)
      at = lines_.size();
    else if (says(block.where, "at the top of the file"))
      at = 0;
    for (const std::string& line : block.lines) {
      if (!atEnd && !line.starts_with('[')) removeGiven(at, line.substr(0, line.find(' ')));
      const int number = isSyntax_ ? number_ : 0;  // a mended line is still the line of other messages
      lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(std::min(at, lines_.size())), {number, line});
      ++at;
    }
  }

  /// Removes an earlier line with the same key.
  void removeGiven(std::size_t& at, const std::string& name) {
    std::size_t place = 0;
    if (removeKey(at > 0 ? at - 1 : 0, name, place) && place < at) --at;
  }

  std::vector<Line> lines_;
  bool isSyntax_ = false;  ///< whether the present message is on the syntax of a line
  int number_ = 0;         ///< line of the present message
};

}  // namespace

std::string mended(const std::string& text, const std::vector<Problem>& problems) {
  Editor editor(text);
  for (const bool syntax : {true, false})  // a line must be TOML before its key matters
    for (const Problem& problem : problems)
      if (isSyntax(problem) == syntax) editor.apply(problem);
  return editor.text();
}

}  // namespace poinsot::scene
