// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/error.h"

namespace poinsot::scene {

/// One thing wrong with a scene: where, what was expected, what was got, the repair. All text is safe to print.
struct Problem {
  core::SourceLocation where;  ///< the value (the key where the key is wrong); line 0 for "-D key=value"
  std::string message;         ///< begins with the key's path
  std::string sourceLine;      ///< the line, or the part of a long one around the place; empty when there is none
  int caret = 0;               ///< columns of sourceLine before the place
  int caretLength = 0;         ///< columns of sourceLine to underline, at least 1 where there is a line
};

/// "file:line:column: error: message", the line and a row of carets under the place; no newline at the end.
std::string toString(const Problem& problem);

/// A value that is allowed and may still be a slip.
struct Doubt {
  core::SourceLocation where;
  std::string message;  ///< begins with the key's path; safe to print
};

/// "file:line:column: note: message"; no newline at the end.
std::string toString(const Doubt& doubt);

/// Everything wrong with a scene, in the order of the file. what() is the whole report.
class SceneErrors : public core::Error {
 public:
  /// @pre at least one problem; `omitted` counts those beyond the ones listed.
  explicit SceneErrors(std::vector<Problem> problems, int omitted = 0);

  const std::vector<Problem>& problems() const { return problems_; }
  int omitted() const { return omitted_; }

 private:
  std::vector<Problem> problems_;
  int omitted_;
};

}  // namespace poinsot::scene
