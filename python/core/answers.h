// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace poinsot::python {

/// Declares the module's functions that answer questions about scenes, trajectories and pictures: grades,
/// comparisons, stability maps, explanations.
void declareAnswers(pybind11::module_& module);

}  // namespace poinsot::python
