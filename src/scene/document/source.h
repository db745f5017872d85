// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document/problem.h"

namespace poinsot::scene {

/// Returns the number of characters in UTF-8 text. Counts all bytes except continuation bytes.
std::size_t characterCount(std::string_view text);

/// Text of a scene file, or of one override "-D key=value". Must outlive every Place that refers to it.
class Source {
 public:
  Source(std::string name, std::string text);
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

  /// Returns a line without its line end; empty beyond the last line.
  /// @param number  line number, from 1
  std::string_view line(int number) const;

  /// Returns whether a message can show a line of the source. False for an override "-D key=value", because the
  /// name of its source already contains the complete text.
  bool hasLines() const { return hasLines_; }
  void setWithoutLines() { hasLines_ = false; }

 private:
  std::string name_;
  std::string text_;
  std::vector<std::size_t> lineStarts_;
  bool hasLines_ = true;
};

/// Position in a source. Columns count characters, not bytes, from 1.
struct Place {
  const Source* source = nullptr;
  int line = 0;
  int column = 0;
  int length = 1;  ///< number of characters, all of them on this line
};

/// Returns the position as a message shows it. Line and column are 0 for a source without lines.
core::SourceLocation locationOf(const Place& place);

/// List of the problems found, so that one run reports all of them.
class Problems {
 public:
  void add(const Place& place, std::string message);
  /// Returns the message of the last problem, for a change. @pre it is not a message that is computed later
  std::string& lastMessage() { return found_.back().message; }
  /// Adds a problem whose message takes long to compute. The message is computed only if the problem is reported.
  /// @pre everything that `message` refers to lives until throwIfAny().
  void addLater(const Place& place, std::function<std::string()> message);
  bool empty() const { return found_.empty(); }
  std::size_t size() const { return found_.size(); }
  /// Throws if at least one problem was added.
  /// @throws SceneErrors with all problems, in the order of the file.
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
