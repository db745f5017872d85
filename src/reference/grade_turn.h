// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Returns hypotheses that a log's axes are turned by a constant rotation, which is fitted. Rotations that
/// exchange or reverse the coordinate axes are preferred. The frames turned are, in order: both alike
/// (forward-right-down, left-handed axes), the body's, that of space, one frame of q alone, and one of omega
/// alone.
///
/// Mirrors need no hypothesis of their own. With M the matrix of the mirrored axes, R' = M R M^-1, and omega' =
/// det(M) M omega, because omega and L are axial vectors. The proper rotation -M has the same effect.
std::vector<Hypothesis> turnHypotheses();

/// Returns a hypothesis for each exchange of coordinate axes, with both frames turned alike. Try them before a
/// hypothesis that cannot be fitted while the axes are turned.
std::vector<Hypothesis> exchangeHypotheses();

/// Returns the hypothesis that both frames are turned, each by a rotation of its own. Try this hypothesis last,
/// because its six free numbers also fit many other conventions.
Hypothesis twoTurnsHypothesis();

}  // namespace poinsot::reference
