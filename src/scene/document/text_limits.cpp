// SPDX-License-Identifier: Apache-2.0
#include "scene/document/text_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace poinsot::scene {
namespace {

/// Scanner for TOML text. Implements only as much of the grammar as is necessary to skip comments and strings and
/// to distinguish keys from values.
class Scan {
 public:
  Scan(const Source& source, const Limits& limits) : source_(source), text_(source.text()), limits_(limits) {}

  std::optional<LimitExceeded> run() {
    while (!exceeded_ && at_ < text_.size()) step();
    return exceeded_;
  }

  std::optional<Place> openArrayAt(int line) {
    while (at_ < text_.size() && line_ < line) step();
    return open_.empty() || open_.back().table ? std::nullopt : std::optional(open_.back().place);
  }

 private:
  struct Open {
    bool table;
    int depth;  // nesting depth outside the table or array
    Place place;
  };

  void step() {
    const char c = text_[at_];
    if (c == '#') return skipComment();
    if (c == '"' || c == '\'') return skipString(c);
    if (c == '\n') newLine();
    if (c == '[') openArray();
    if (c == '{') open(true);
    if (c == ']' || c == '}') close();
    if (c == '=') equals();
    if (c == ',') comma();
    if (c == '.' && inKey_) deeper();
    ++at_;
  }

  void skipComment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  // Skips a string. An unclosed string ends with the line or the text; the parser reports it later.
  void skipString(char quote) {
    const std::size_t begin = at_;
    const std::string fence(text_.substr(at_, 3) == std::string(3, quote) ? 3 : 1, quote);
    at_ += fence.size();
    while (at_ < text_.size() && !text_.substr(at_).starts_with(fence)) {
      if (fence.size() == 1 && text_[at_] == '\n') return;
      if (text_[at_] == '\n') startLine();
      const bool escapes = quote == '"' && text_[at_] == '\\' && !text_.substr(at_ + 1).starts_with('\n');
      at_ += escapes ? 2 : 1;
    }
    at_ = std::min(at_ + fence.size(), text_.size());
    // A string in triple quotes may end with quotes of its own: """a"""" contains a".
    for (int extra = 0; fence.size() == 3 && extra < 2 && text_.substr(at_).starts_with(quote); ++extra) ++at_;
    if (at_ - begin > limits_.bytes(Limit::kStringBytes) + 2 * fence.size())
      exceed(Limit::kStringBytes, "a string may have at most {}");
  }

  void startLine() {
    ++line_;
    lineStart_ = at_ + 1;
  }

  void newLine() {
    startLine();
    if (!open_.empty()) return;
    if (inHeader_) headerDepth_ = depth_;
    inHeader_ = false;
    depth_ = headerDepth_;
    inKey_ = true;
  }

  void openArray() {
    const bool header = open_.empty() && inKey_;
    if (!header) return open(false);
    depth_ = 0;
    inHeader_ = true;
    count();
  }

  void open(bool table) {
    open_.push_back({table, depth_, placeHere()});
    deeper();
    inKey_ = table;
  }

  void close() {
    if (open_.empty()) return;
    depth_ = open_.back().depth;
    open_.pop_back();
    inKey_ = false;
  }

  void equals() {
    inKey_ = false;
    count();
  }

  void comma() {
    count();
    if (open_.empty()) return;
    inKey_ = open_.back().table;
    depth_ = open_.back().depth + 1;
  }

  void deeper() {
    count();
    if (++depth_ > limits_[Limit::kNesting])
      exceed(Limit::kNesting, "tables and arrays may be nested at most {} deep");
  }

  void count() {
    if (++nodes_ > limits_[Limit::kValues]) exceed(Limit::kValues, "a scene may hold at most {} values");
  }

  void exceed(Limit limit, const char* message) {
    if (exceeded_) return;
    exceeded_ = LimitExceeded{placeHere(), messageOf(limit, message)};
  }

  Place placeHere() const {
    const std::size_t end = std::min(at_, text_.size());
    const auto before = characterCount(text_.substr(lineStart_, end - std::min(lineStart_, end)));
    return {&source_, line_, static_cast<int>(before) + 1, 1};
  }

  std::string messageOf(Limit limit, const char* message) const {
    return fmt::format("{}; {}", fmt::format(fmt::runtime(message), limitText(limit, limits_[limit])),
                       howToRaise(limit));
  }

  const Source& source_;
  const std::string_view text_;
  const Limits& limits_;
  std::size_t at_ = 0;
  std::size_t lineStart_ = 0;
  int line_ = 1;
  std::int64_t nodes_ = 0;
  int depth_ = 0;        // nesting depth at the current position
  int headerDepth_ = 0;  // nesting depth of the last [header]
  bool inKey_ = true;
  bool inHeader_ = false;
  std::vector<Open> open_;
  std::optional<LimitExceeded> exceeded_;
};

}  // namespace

std::optional<LimitExceeded> exceededLimit(const Source& source, const Limits& limits) {
  constexpr Limit kBytes = Limit::kSceneBytes;
  if (source.text().size() > limits.bytes(kBytes))
    return LimitExceeded{{&source, 0, 0, 1},
                         fmt::format("a scene file may have at most {}; {}", limitText(kBytes, limits[kBytes]),
                                     howToRaise(kBytes))};
  return Scan(source, limits).run();
}

std::optional<Place> openArrayAtLine(const Source& source, const Limits& limits, int line) {
  return Scan(source, limits).openArrayAt(line);
}

}  // namespace poinsot::scene
