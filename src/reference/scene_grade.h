// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "reference/grade.h"
#include "scene/scene.h"

namespace poinsot::reference {

/// Grades a log against the motion of a scene, made over the log's times.
/// @throws core::Error(kLimit) if a driven motion is too long. For a log on a clock's time, far from 0, the
/// message also gives the log's errors counted from its first row.
Grade gradeAgainst(const scene::Scene& scene, const TrajectoryTable& theirs);

/// Parses the largest attitude error that passes: a number in rad or an angle with its unit, "1e-6" or "0.1 deg".
/// @returns rad. @throws core::Error(kUsage) with `name` and `word` if the word is no angle, or negative.
double attitudeLimit_rad(std::string_view name, std::string_view word);

}  // namespace poinsot::reference
