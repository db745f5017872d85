// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/grade_reading.h"

namespace poinsot::reference {

/// Logs whose axes are turned once and for all, by the rotation that fits best; one that exchanges or turns round
/// the coordinate axes is preferred. The frames turned: both alike (forward-right-down, left-handed axes), the
/// body's, that of space; then one frame of q alone, or of omega alone.
///
/// A mirror is among them. With M the mirrored axes' matrix, R' = M R M^-1 and, omega and L being axial vectors,
/// omega' = det(M) M omega: that is what the proper rotation -M makes of them.
std::vector<Hypothesis> turnHypotheses();

/// Both frames turned alike, once for each exchange of coordinate axes: to be tried before a hypothesis that
/// cannot be fitted while the axes are turned.
std::vector<Hypothesis> exchangeHypotheses();

/// Both frames turned, each by a rotation of its own. Its six free numbers fit many other conventions too, so it
/// is tried last.
Hypothesis twoTurnsHypothesis();

}  // namespace poinsot::reference
