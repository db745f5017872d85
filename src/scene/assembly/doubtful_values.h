// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/keys/findings.h"

namespace poinsot::scene {

/// Doubts what is hardly ever meant: a bare whole number as an angle (who means radians writes a fraction), a bare
/// length of metres in a body whose other lengths have units, a density that no matter has.
void doubtValues(const Leaves& leaves, Findings& findings);

}  // namespace poinsot::scene
