// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "text/math_alphabet.h"
#include "text/math_layout.h"

namespace poinsot::text {

enum class CommandKind {
  kSymbol,  ///< one character, the same in every alphabet
  kLetter,  ///< a letter in the current alphabet
  kAccent,
  kSpace,
  kFunction,  ///< an upright name: \sin
  kAlphabet,  ///< \mathbf{...}: an alphabet for its argument
  kText,      ///< \text{...}, \textbf{...}: running text
  kFraction,
  kDisplayFraction,  ///< a fraction with its parts in the type size of the line
  kRoot,
};

/// Command \name of the language. The kind decides which fields are used.
struct Command {
  std::string_view name;
  CommandKind kind = CommandKind::kSymbol;
  char32_t character = 0;
  AtomClass atomClass = AtomClass::kOrdinary;
  Alphabet alphabet = Alphabet::kRoman;
  double width_em = 0;
  bool inText = false;  ///< allowed outside $...$ too
};

std::span<const Command> commands();

/// Returns null if there is no such command.
const Command* findCommand(std::string_view name);

/// Returns the command whose name is nearest to a mistyped one; empty if none is near.
std::string nearestCommand(std::string_view name);

/// Sign that a typed character stands for in formulas: '-' is the minus sign, a binary operator.
struct Symbol {
  char32_t character = 0;
  AtomClass atomClass = AtomClass::kOrdinary;
};
Symbol symbolOf(char32_t typed);

}  // namespace poinsot::text
