// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document/problem.h"

namespace poinsot::scene {

/// Counts the characters of UTF-8 text: all bytes except continuation bytes.
std::size_t characterCount(std::string_view text);

/// Text that contains keys and values: a scene file, or one "-D key=value". Must outlive every Place in it.
class Source {
 public:
  Source(std::string name, std::string text);
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

  /// Returns line `number` (from 1) without its line end; empty beyond the last line.
  std::string_view line(int number) const;

  /// Returns false for "-D", whose name is the whole text: its problems show no line.
  bool hasLines() const { return hasLines_; }
  void setWithoutLines() { hasLines_ = false; }

 private:
  std::string name_;
  std::string text_;
  std::vector<std::size_t> lineStarts_;
  bool hasLines_ = true;
};

/// Place in a source. Columns count characters (not bytes) from 1.
struct Place {
  const Source* source = nullptr;
  int line = 0;
  int column = 0;
  int length = 1;  ///< number of characters, all on this line
};

/// Returns the place for a message, with a printable file name. Line and column are 0 in a source without lines.
core::SourceLocation locationOf(const Place& place);

/// Collector of problems, so that one run reports all of them.
class Problems {
 public:
  void add(const Place& place, std::string message);
  /// Adds a problem whose message takes time to make; makes the message only if the problem is reported.
  /// @pre everything that `message` refers to lives until throwIfAny().
  void addLater(const Place& place, std::function<std::string()> message);
  bool empty() const { return found_.empty(); }
  std::size_t size() const { return found_.size(); }
  /// @throws SceneErrors with the problems added, in the order of the file.
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
