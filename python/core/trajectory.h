// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loaded_scene.h"

namespace poinsot::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style>;

/// Motion at some times, with the names of poinsot.Trajectory. The shape of each array is the shape of the times,
/// followed by the shape of one value.
struct TrajectoryArrays {
  Doubles q_WB, R_WB, omega_B, omega_W, L_W, T;
  Doubles rate_B, rate_W;
  std::vector<Doubles> quantities;  ///< arrays of the named quantities, in the order of their names
  std::string note;                 ///< remark on the accuracy; empty if exact
};

/// Computes the motion at some times. @param times_s  motion times, finite.
/// @param span_s  first and last time over which a driven motion is integrated; default: those of times_s. The
/// span always includes 0.
/// @param quantities  names of further quantities, as in reference::ChosenColumns, without the time
/// @throws core::Error(kUsage) for an unknown quantity; core::Error as scene::makeMotion() and
/// physics::Motion::at(), naming the time.
TrajectoryArrays trajectoryOf(const LoadedScene& scene, const Doubles& times_s,
                              const std::optional<std::pair<double, double>>& span_s,
                              const std::vector<std::string>& quantities);

/// Returns the events of a scene in a span of motion time as JSON, as `poinsot trajectory --events` writes them.
/// @param span_s  ends of the span; default: the span of the film
/// @throws core::Error as scene::makeMotion() and scene::sceneEvents().
std::string eventsJson(const LoadedScene& scene, const std::optional<std::pair<double, double>>& span_s);

}  // namespace poinsot::python
