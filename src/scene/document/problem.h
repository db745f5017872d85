// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace poinsot::scene {

/// Error in a scene, with its position and a message. The message names the expected value, the given value and
/// how to repair the error. All text is safe to print.
struct Problem {
  core::SourceLocation where;  ///< position of the wrong value or key; line 0 for "-D key=value"
  std::string message;         ///< text of the error; begins with the path of the key
  std::string sourceLine;      ///< line that contains the error, or a part of a long line; empty for -D
  int caret = 0;               ///< number of columns of sourceLine before the error
  int caretLength = 0;         ///< number of columns to underline; at least 1 unless sourceLine is empty
};

/// Formats a problem as "file:line:column: error: message", the line of the source, and carets under the error.
/// There is no newline at the end.
std::string toString(const Problem& problem);

/// Note on a valid value that is probably a mistake.
struct Doubt {
  core::SourceLocation where;
  std::string message;  ///< text of the note; begins with the path of the key; safe to print
};

/// Formats a note as "file:line:column: note: message", without a newline at the end.
std::string toString(const Doubt& doubt);

/// Exception with all errors of a scene, in the order of the file. what() returns the complete report.
class SceneErrors : public core::Error {
 public:
  /// @param omitted  number of further problems that the list does not contain
  /// @pre at least one problem
  explicit SceneErrors(std::vector<Problem> problems, int omitted = 0);

  const std::vector<Problem>& problems() const { return problems_; }
  int omitted() const { return omitted_; }

 private:
  std::vector<Problem> problems_;
  int omitted_;
};

}  // namespace poinsot::scene
