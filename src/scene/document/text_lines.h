// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/document/document.h"

namespace poinsot::scene {

/// Splits text into lines, each with its position. For an array, returns the elements. For a string, splits at
/// line ends; a line end at the end of the string adds no line. For any other value, returns the value itself.
std::vector<Node> linesOf(const Node& node);

}  // namespace poinsot::scene
