// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include "loaded_scene.h"

namespace poinsot::python {

/// Numbers of a scene's stability map (stage::StabilityMap).
struct StabilityNumbers {
  pybind11::array_t<double> flipInterval;        ///< s, for each direction; infinite on the separatrix
  pybind11::array_t<double> moments, R_BP, L_P;  ///< 3 values, kg·m²; 3x3, P to B; the scene's, kg·m²/s
  pybind11::array_t<double> separatrix;          ///< 2 great circles of n unit vectors in P
  double sceneInterval_s = 0;
  double least_s = 0, most_s = 0;  ///< ends of the scale of colours
  bool logarithmic = false;
};

using Directions = pybind11::array_t<double, pybind11::array::c_style>;

/// Computes the numbers for some directions. @param directions_P  n rows of 3: unit vectors in principal axes.
/// @throws core::Error(kPhysics) as stage::StabilityMap.
StabilityNumbers stabilityOf(const LoadedScene& scene, const Directions& directions_P);

}  // namespace poinsot::python
