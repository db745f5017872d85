// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Returns hypotheses that the log's axes are rotated by a constant rotation, which is fitted. Rotations that
/// exchange or reverse coordinate axes are preferred. The rotated axes are, in this order: body and space alike
/// (such as forward-right-down, or left-handed axes), body, space, body or space for q only, and the axes of omega
/// only.
///
/// Mirrored axes need no hypothesis of their own. If M is the matrix of the mirrored axes, then R' = M R M^-1.
/// Because omega and L are axial vectors, omega' = det(M) M omega. The rotation -M has the same effect.
std::vector<Hypothesis> turnHypotheses();

/// Returns a hypothesis for each exchange of coordinate axes, the same for body and space. Combine these
/// hypotheses with others that can be fitted only after the axes are right.
std::vector<Hypothesis> exchangeHypotheses();

/// Returns the hypothesis that the axes of body and space are rotated differently. Try this hypothesis last,
/// because its six free parameters also fit many other conventions.
Hypothesis twoTurnsHypothesis();

}  // namespace poinsot::reference
