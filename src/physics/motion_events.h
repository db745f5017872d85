// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/abi.h"
#include "physics/driven_motion.h"
#include "physics/forcing.h"
#include "physics/motion.h"

namespace poinsot::physics {

enum class MotionEventKind {
  kFlip,        ///< omega along the middle axis changes sign, and L comes within 20° of this axis (FlipTimes)
  kReversal,    ///< omega along the middle axis changes sign, but L stays away from this axis
  kSeparatrix,  ///< L^2 - 2 T I_mid changes sign, so that the polhode runs about another axis from then on
  kLeastTilt,   ///< the tilt of a heavy top, the angle between k and the vertical, is smallest
  kMostTilt,    ///< the tilt of a heavy top is largest
};

/// Instant at which something happens in a rotation.
struct MotionEvent {
  MotionEventKind kind = MotionEventKind::kFlip;
  double t_s = 0;  ///< motion time
};

/// Returns the events of a rotation in a span of time, in the order from its first end to its second end. Both
/// ends belong to the span.
/// - Flips, reversals and crossings of the separatrix exist for three different moments, unless gravity acts.
/// - The tilt exists for a symmetric top in gravity (heavyTop()).
///
/// The flips of a free motion are exact at any time: after the first one, they follow in steps of
/// FlipTimes::interval_s. Other events are roots of a function of the motion. They are bracketed by samples, 25
/// for each turn of the body at its fastest, and then bisected to the last bit. A wobble or nutation that is
/// smaller than the fraction 1e-10 of omega has no events.
/// @param motion  motion under the forcing, which covers the span
/// @throws core::Error(kLimit) for more than a million flips or for more turns than samples can follow
std::vector<MotionEvent> motionEvents(const Motion& motion, const Forcing& forcing, const TimeSpan& span);

static_assert(core::laidOut<MotionEvent, 16>());

}  // namespace poinsot::physics
