// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/document/document.h"

namespace poinsot::scene {

/// Splits a text into lines, each with its place. An array yields its elements. A string is split at its line
/// ends, ignoring one at the end. Any other value is returned unchanged as the only line.
std::vector<Node> linesOf(const Node& node);

}  // namespace poinsot::scene
