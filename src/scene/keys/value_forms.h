// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "scene/document/document.h"
#include "scene/keys/keys.h"

/// Forms in which other programs write a value, and the form that a key of this program takes.
namespace poinsot::scene {

/// Returns the number of a node that is an integer or a decimal; otherwise empty.
std::optional<double> numberIn(const Node& node);

/// Returns whether a node is a number or a text.
bool isScalar(const Node& node);

Node zeroAt(const Place& place);

Node listNode(std::vector<Node> elements, const Place& place);

/// Returns a number times a factor. The number may have a unit. An array is scaled element by element.
Node scaled(const Node& given, double factor);

/// Returns a bare number, or an array of them, with a unit. Leaves other values and SI units as they are.
Node withUnit(const Node& given, std::string_view unit, Dimension dimension);

/// Returns the numbers of a text such as "0 0 1", "(0, 0, 1)" and "[1 0; 0 1]" as an array, and several rows as an
/// array of arrays. Empty for other texts.
std::optional<Node> numbersIn(const Node& given);

/// Returns the forms of a value to try for a key, its own form first.
std::vector<Node> formsOf(const Key& key, const Node& given);

/// Returns the numbers of a value in TOML in SI units, such as three for `[1, 2, "3 g cm^2"]`, without the
/// structure of the arrays. Empty if one of them is not a number.
std::vector<double> numbersInToml(std::string_view text, Dimension dimension);

/// Returns whether bare numbers of an angle are probably degrees: more than a turn in radians, or whole numbers
/// of at least four.
bool areDegrees(const Node& given);

}  // namespace poinsot::scene
