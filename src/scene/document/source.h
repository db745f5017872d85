// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document/problem.h"

namespace poinsot::scene {

/// Characters in UTF-8 text: bytes that do not continue one.
std::size_t characterCount(std::string_view text);

/// A text that keys and values come from: a scene file, or one "-D key=value". Outlives every Place in it.
class Source {
 public:
  Source(std::string name, std::string text);
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

  /// Line `number` (from 1) without its line end; empty beyond the last.
  std::string_view line(int number) const;

  /// False for "-D", whose name is the whole text: its problems carry no line.
  bool hasLines() const { return hasLines_; }
  void setWithoutLines() { hasLines_ = false; }

 private:
  std::string name_;
  std::string text_;
  std::vector<std::size_t> lineStarts_;
  bool hasLines_ = true;
};

/// Where something stands in a source. Columns count characters (not bytes) from 1.
struct Place {
  const Source* source = nullptr;
  int line = 0;
  int column = 0;
  int length = 1;  ///< characters, all on this line
};

/// The place in words for a person; line and column are 0 in a source without lines. The file's name is printable.
core::SourceLocation locationOf(const Place& place);

/// Gathers what is wrong, so that one run reports it all.
class Problems {
 public:
  void add(const Place& place, std::string message);
  /// For messages that take time to make (what was meant?): only those that are reported are made.
  /// @pre what `message` refers to lives until throwIfAny().
  void addLater(const Place& place, std::function<std::string()> message);
  bool empty() const { return found_.empty(); }
  std::size_t size() const { return found_.size(); }
  /// @throws SceneErrors with all that was added, in the order of the file.
  void throwIfAny();

 private:
  struct Found {
    Place place;
    std::string message;
    std::function<std::string()> make{};
  };
  std::vector<Found> found_;
};

}  // namespace poinsot::scene
