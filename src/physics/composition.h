// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/abi.h"

namespace poinsot::physics {

/// How the sub-flows of a splitting are put together into one step of some order: a kick, a drift, a kick, ... a
/// kick. All are palindromes: a step back undoes a step.
struct Composition {
  const char* name;
  int order;
  /// Made of symmetric steps of order 2, so that a drift may have other flows symmetrically around it. The others
  /// have their order only for kicks by torques that do not depend on the angular momentum.
  bool ofSymmetricSteps;
  /// Where in the step, as a part of it, each free flow ends; the last is 1.
  std::vector<double> drifts;
  /// As much of the torque's impulse as has been given when each free flow begins; the rest after the last.
  std::vector<double> kicks;
};

/// Half a kick, a drift, half a kick (Strang, Verlet).
const Composition& strang2();

/// Runge-Kutta-Nyström, order 4, 6 drifts: only for torques that do not depend on the angular momentum.
/// Source: S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313, method SRKN 6b.
const Composition& nystrom4();

/// The same, order 6, 11 drifts: method SRKN 11b.
const Composition& nystrom6();

/// Order 8 from any symmetric step of order 2, 17 of them. Source: W. Kahan, R.-C. Li, Math. Comp. 66 (1997) 1089.
const Composition& kahanLi8();

}  // namespace poinsot::physics
