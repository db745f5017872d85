// SPDX-License-Identifier: Apache-2.0
#include "scene/event_kinds.h"

namespace poinsot::scene {
namespace {

// The index of each of the first five kinds is a physics::MotionEventKind.
constexpr EventKind kKinds[] = {
    {"flip", "flips", "omega_mid changes sign"},
    {"reversal", "reversals along the middle axis", "omega_mid changes sign, without a flip"},
    {"separatrix", "crossings of the separatrix", "L^2 - 2 T I_mid changes sign"},
    {"least_tilt", "nutation: least tilt", "turning point"},
    {"largest_tilt", "nutation: largest tilt", "turning point"},
    {"highest_point", "highest point of the flight", "V_z = 0"},
    {"catch", "catch", "the thrown body is back at the height of the throw"},
};

}  // namespace

std::span<const EventKind> eventKinds() { return kKinds; }

}  // namespace poinsot::scene
