// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/abi.h"

namespace poinsot::physics {

/// Arrangement of the sub-flows of a splitting into one step of some order: kick, drift, kick, ..., kick. Every
/// composition is a palindrome, so that a step back undoes a step.
struct Composition {
  const char* name;
  int order;
  /// True if the composition consists of symmetric steps of order 2, in which other flows may surround a drift
  /// symmetrically. Other compositions have their order only if the torques do not depend on the angular momentum.
  bool ofSymmetricSteps;
  /// Point of the step at which each free flow ends, as a fraction of the step; the last is 1.
  std::vector<double> drifts;
  /// Total fraction of the torque's impulse given before each free flow; the rest follows the last flow.
  std::vector<double> kicks;
};

/// Returns the Strang (Verlet) composition: half a kick, a drift, half a kick.
const Composition& strang2();

/// Returns a Runge-Kutta-Nyström composition of order 4 with 6 drifts, only for torques that do not depend on the
/// angular momentum. Source: S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313, method SRKN 6b.
const Composition& nystrom4();

/// Returns the composition of order 6 with 11 drifts from the same paper as nystrom4(), method SRKN 11b.
const Composition& nystrom6();

/// Returns a composition of order 8 from 17 symmetric steps of order 2, for any such step. Source: W. Kahan, R.-C.
/// Li, Math. Comp. 66 (1997) 1089.
const Composition& kahanLi8();

}  // namespace poinsot::physics
