// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/abi.h"

namespace poinsot::physics {

/// Sequence of kicks and drifts (splitting.h) that form one integration step: kick, drift, kick, ..., kick. Every
/// composition is a palindrome, so that a step backwards undoes a step forwards.
struct Composition {
  const char* name;
  int order;
  /// True if the composition consists of symmetric steps of order 2. Only such a composition keeps its order if
  /// torques depend on the angular momentum, as drag does.
  bool ofSymmetricSteps;
  /// Times at which the drifts end, as fractions of the step. The last value is 1.
  std::vector<double> drifts;
  /// Running sum of the kicks up to each drift, as a fraction of the total impulse. The kick after the last drift
  /// adds the rest.
  std::vector<double> kicks;
};

/// Returns the Strang (Verlet) composition: half a kick, a drift, half a kick.
const Composition& strang2();

/// Returns a Runge-Kutta-Nyström composition of order 4 with 6 drifts. Use it only for torques that do not depend
/// on the angular momentum. Source: S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313, method SRKN 6b.
const Composition& nystrom4();

/// Returns the composition of order 6 with 11 drifts from the same paper as nystrom4(), method SRKN 11b.
const Composition& nystrom6();

/// Returns a composition of order 8 that consists of 17 symmetric steps of order 2, of any kind. Source: W. Kahan,
/// R.-C. Li, Math. Comp. 66 (1997) 1089.
const Composition& kahanLi8();

}  // namespace poinsot::physics
