// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "text/math_alphabet.h"
#include "text/math_layout.h"

namespace poinsot::text {

enum class CommandKind {
  kSymbol,  ///< character that is the same in every alphabet
  kLetter,  ///< letter, drawn in the current alphabet
  kAccent,
  kSpace,
  kFunction,  ///< function name in upright letters, such as \sin
  kAlphabet,  ///< alphabet for its argument: \mathbf{...}
  kText,      ///< running text as its argument: \text{...}, \textbf{...}
  kFraction,
  kDisplayFraction,  ///< fraction whose parts have the text size of the line
  kRoot,
  kMatrix,  ///< \begin, whose only environment is {bmatrix}
};

/// Command of the TeX subset. `kind` determines which other fields are used.
struct Command {
  std::string_view name;
  CommandKind kind = CommandKind::kSymbol;
  char32_t character = 0;
  AtomClass atomClass = AtomClass::kOrdinary;
  Alphabet alphabet = Alphabet::kRoman;
  double width_em = 0;
  bool inText = false;  ///< whether the command is also allowed outside $...$
};

std::span<const Command> commands();

/// Returns the command with the given name, or null if there is no such command.
const Command* findCommand(std::string_view name);

/// Returns the command whose name is most similar to a mistyped name. Empty if no name is similar.
std::string nearestCommand(std::string_view name);

/// Character that is drawn for a typed character in formulas. '-' is drawn as minus, a binary operator.
struct Symbol {
  char32_t character = 0;
  AtomClass atomClass = AtomClass::kOrdinary;
};
Symbol symbolOf(char32_t typed);

}  // namespace poinsot::text
