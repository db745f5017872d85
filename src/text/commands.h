// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "text/math_alphabet.h"
#include "text/math_layout.h"

namespace poinsot::text {

enum class CommandKind {
  kSymbol,    ///< one character, the same in every alphabet
  kLetter,    ///< a letter, shaped by the alphabet in force
  kAccent,    ///< a mark over its argument
  kSpace,     ///< a width
  kFunction,  ///< an upright name: \sin
  kAlphabet,  ///< \mathbf{...}: an alphabet for its argument
  kText,      ///< \text{...}, \textbf{...}: running text
  kFraction,
  kDisplayFraction,  ///< its parts as large as the line's type
  kRoot,
};

/// One \name of the language; which fields count depends on the kind.
struct Command {
  std::string_view name;
  CommandKind kind = CommandKind::kSymbol;
  char32_t character = 0;
  AtomClass atomClass = AtomClass::kOrdinary;
  Alphabet alphabet = Alphabet::kRoman;
  double width_em = 0;
  bool inText = false;  ///< also outside $...$
};

/// Every command there is.
std::span<const Command> commands();

/// Null where there is no such command.
const Command* findCommand(std::string_view name);

/// The command a mistyped name was meant to be; empty when none is near.
std::string nearestCommand(std::string_view name);

/// A character of mathematics as typed, and what stands for it: '-' is the minus sign, a binary operator.
struct Symbol {
  char32_t character = 0;
  AtomClass atomClass = AtomClass::kOrdinary;
};
Symbol symbolOf(char32_t typed);

}  // namespace poinsot::text
