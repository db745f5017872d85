// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace poinsot::scene {

/// Kind of an event of a scene: the kinds of physics::MotionEventKind, and two points of a flight.
struct EventKind {
  std::string_view word;     ///< word in files, such as "flip"
  std::string_view plural;   ///< name in a table, such as "flips"
  std::string_view meaning;  ///< condition of the event, such as "omega_mid changes sign"
};

/// Returns all kinds, in the order of the reference. Events store indices into this list.
std::span<const EventKind> eventKinds();

/// Indices of the kinds that physics::MotionEventKind lacks.
constexpr int kHighestPoint = 5, kCatch = 6;

}  // namespace poinsot::scene
