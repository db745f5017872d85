// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace poinsot::scene {

/// Error in a scene: its place, and a message with the expected and the given value and the repair. All text is
/// safe to print.
struct Problem {
  core::SourceLocation where;  ///< of the value (of the key if the key is wrong); line 0 for "-D key=value"
  std::string message;         ///< begins with the path of the key
  std::string sourceLine;      ///< the line, or the part of a long line around the place; empty without lines
  int caret = 0;               ///< columns of sourceLine before the place
  int caretLength = 0;         ///< columns of sourceLine to underline, at least 1 if there is a line
};

/// Formats "file:line:column: error: message", the line, and carets under the place; without a newline at the end.
std::string toString(const Problem& problem);

/// Valid value that is probably a slip.
struct Doubt {
  core::SourceLocation where;
  std::string message;  ///< begins with the path of the key; safe to print
};

/// Formats "file:line:column: note: message", without a newline at the end.
std::string toString(const Doubt& doubt);

/// All errors in a scene, in the order of the file. what() is the whole report.
class SceneErrors : public core::Error {
 public:
  /// @param omitted  number of problems beyond the listed ones
  /// @pre at least one problem
  explicit SceneErrors(std::vector<Problem> problems, int omitted = 0);

  const std::vector<Problem>& problems() const { return problems_; }
  int omitted() const { return omitted_; }

 private:
  std::vector<Problem> problems_;
  int omitted_;
};

}  // namespace poinsot::scene
