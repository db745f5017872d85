// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "reference/grade.h"
#include "scene/scene.h"

namespace poinsot::reference {

/// Grades a log against the motion of a scene, made over the log's times.
/// @throws core::Error(kLimit) if a driven motion is too long; for a log on a clock's time, far from 0, the
/// message also gives its errors from the first row on.
Grade gradeAgainst(const scene::Scene& scene, const TrajectoryTable& theirs);

/// The largest attitude error that passes, rad, from a number in rad or an angle with its unit: "1e-6", "0.1 deg".
/// @throws core::Error(kUsage) with `name` and the word if it is no angle, or negative.
double attitudeLimit_rad(std::string_view name, std::string_view word);

}  // namespace poinsot::reference
