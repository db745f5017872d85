// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace poinsot::text {

/// Reads a string of the small TeX language character by character and knows the column.
/// Columns count characters from 1. Every failure is core::Error(kUsage) naming its column and the string.
class TexReader {
 public:
  /// @throws core::Error(kUsage) when `tex` is not UTF-8 or is longer than 2000 characters.
  explicit TexReader(std::string_view tex);

  bool atEnd() const { return position_ == characters_.size(); }
  /// The next character, 0 at the end.
  char32_t peek() const { return atEnd() ? U'\0' : characters_[position_]; }
  char32_t take();
  bool takeIf(char32_t wanted);
  /// The name after a backslash already taken: letters, or one other character.
  std::string takeName();
  void skipBlanks();

  /// Column of the next character.
  std::size_t column() const { return position_ + 1; }
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  /// Held while inside braces or an argument, so that hostile input cannot exhaust the stack.
  class Nested {
   public:
    explicit Nested(TexReader& reader);
    ~Nested() { --reader_.depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

   private:
    TexReader& reader_;
  };

 private:
  std::string tex_;
  std::u32string characters_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

/// A blank: space, tab or end of line.
bool isBlank(char32_t c);

}  // namespace poinsot::text
