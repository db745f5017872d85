// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <utility>

#include "loaded_scene.h"

namespace poinsot::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style>;

/// The motion at some times. The names are those of poinsot.Trajectory; each array has the shape of the times in
/// front of the shape of one value.
struct TrajectoryArrays {
  Doubles q_WB, R_WB, omega_B, omega_W, L_W, T;
  Doubles rate_B, rate_W;
  std::string note;  ///< on their accuracy; empty where exact
};

/// @param times_s  motion times, finite.
/// @param span_s  first and last motion time that a driven motion is integrated over; none: those of times_s. 0
/// always belongs to it.
/// @throws core::Error as scene::makeMotion() and physics::Motion::at(), naming the time.
TrajectoryArrays trajectoryOf(const LoadedScene& scene, const Doubles& times_s,
                              const std::optional<std::pair<double, double>>& span_s);

}  // namespace poinsot::python
