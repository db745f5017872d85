// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/document/problem.h"

/// A reader of messages who knows nothing else about the program.
namespace poinsot::scene {

/// Returns a scene after all that its messages say is done once: names that are to be left out are removed, and
/// the lines of each example stand where the message says, in place of what they replace. Messages without an
/// example change nothing.
std::string mended(const std::string& text, const std::vector<Problem>& problems);

}  // namespace poinsot::scene
