// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/findings.h"

namespace poinsot::scene {

/// Doubts bare whole numbers as angles: who means radians writes a fraction.
void doubtWholeAngles(const Leaves& leaves, Findings& findings);

}  // namespace poinsot::scene
