// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace poinsot::text {

/// Reads a text in the small TeX subset character by character. Columns are counted in characters, from 1. All
/// errors are core::Error(kUsage) with the column and the text.
class TexReader {
 public:
  /// @throws core::Error(kUsage) if `tex` is not UTF-8 or is longer than 2000 characters.
  explicit TexReader(std::string_view tex);

  bool atEnd() const { return position_ == characters_.size(); }
  char32_t peek() const { return atEnd() ? U'\0' : characters_[position_]; }
  char32_t take();
  bool takeIf(char32_t wanted);
  /// Returns whether the next characters are these.
  bool isAt(std::u32string_view characters) const;
  bool takeIf(std::u32string_view wanted);
  /// Reads the name of a command after the backslash: a word of letters or one other character.
  std::string takeName();
  void skipBlanks();

  std::size_t column() const { return position_ + 1; }
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  /// Guard for the time in which the inside of braces or an argument is parsed. It limits the nesting depth, so
  /// that malicious input cannot overflow the stack.
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

/// Reports whether a character is a space, a tab or an end of line.
bool isBlank(char32_t c);

}  // namespace poinsot::text
