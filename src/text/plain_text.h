// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::text {

std::string toUtf8(std::u32string_view characters);

/// Functions that return formulas as one line of plain Unicode, for reading aloud and searching: "x₁", "x^(a +
/// b)", "(a + b)/2", "√x".
std::u32string plainSubscript(const std::u32string& script);
std::u32string plainSuperscript(const std::u32string& script);
std::u32string plainFraction(const std::u32string& numerator, const std::u32string& denominator);
std::u32string plainRoot(const std::u32string& content);
/// Returns rows of a matrix with blanks between the elements: "[1 0; 0 1]".
std::u32string plainMatrix(const std::vector<std::vector<std::u32string>>& rows);
/// Adds an index to a root that plainRoot() returned: "∛x", "⁵√x", "[n]√x".
std::u32string plainWithIndex(const std::u32string& index, const std::u32string& root);

}  // namespace poinsot::text
