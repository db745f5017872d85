// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace poinsot::scene {

/// From what was given to what is drawn: line widths become the theme's, times the factor given.
void finishStyle(Style& style);

}  // namespace poinsot::scene
