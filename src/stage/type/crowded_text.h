// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "draw/picture.h"

namespace poinsot::stage {

/// Returns the first text of a picture, in plain Unicode, that overlaps another text or leaves the picture. Empty
/// if all texts have room. Ignores overlaps of less than a fraction of the size of the text.
std::string crowdedText(const draw::Picture& picture);

}  // namespace poinsot::stage
