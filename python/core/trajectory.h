// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <string>

#include "loaded_scene.h"

namespace poinsot::python {

/// The motion at n times; rows in their order. The names are those of poinsot.Trajectory.
struct TrajectoryArrays {
  pybind11::array_t<double> q_WB, R_WB, omega_B, omega_W, L_W, T;  ///< n rows of 4, 3x3, 3, 3, 3 and 1
  pybind11::array_t<double> rate_B, rate_W;                        ///< n rows of 3
  std::string note;                                                ///< on their accuracy; empty where exact
};

/// @param times_s  motion times.
/// @throws core::Error(kUsage) for a time that is not finite, as scene::makeMotion().
TrajectoryArrays trajectoryOf(const LoadedScene& scene, const std::vector<double>& times_s);

}  // namespace poinsot::python
