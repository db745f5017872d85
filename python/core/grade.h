// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "loaded_scene.h"

namespace poinsot::python {

using Column = pybind11::array_t<double, pybind11::array::c_style>;

/// Grades a CSV file, and returns the JSON that `grade --json` prints.
/// @throws core::Error as reference::readTrajectoryTable() and reference::gradeAgainst().
std::string gradeJson(const LoadedScene& scene, const std::string& fileName);

/// Grades columns in memory. @param columns  as many as names, each of one dimension.
/// @throws core::Error as reference::trajectoryTableOf() and reference::gradeAgainst().
std::string gradeJson(const LoadedScene& scene, const std::vector<std::string>& names,
                      const std::vector<Column>& columns);

}  // namespace poinsot::python
