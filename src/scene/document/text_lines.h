// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/document/document.h"

namespace poinsot::scene {

/// The lines of a text, each with its place: the elements of an array; of one text what its line ends part, but
/// for one at its end. What is neither is one line, as it is.
std::vector<Node> linesOf(const Node& node);

}  // namespace poinsot::scene
