// SPDX-License-Identifier: Apache-2.0
#include "reference/scene_grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/number.h"
#include "core/text.h"
#include "scene/motion/make_motion.h"
#include "scene/units.h"

namespace poinsot::reference {
namespace {

bool isFarOff(const Grade& grade) {
  constexpr double kFarOff = 0.1;  // rms error, rad or relative
  return std::ranges::any_of(grade.quantities, [](const GradedQuantity& quantity) {
    return quantity.errors && quantity.errors->rms > kFarOff;
  });
}

/// Returns a note if the log's times are far beyond the film's, perhaps in milliseconds or from another clock.
std::string timeNote(const Grade& grade, const scene::Scene& scene, const physics::TimeSpan& span) {
  constexpr double kFar = 20;
  const double end_s = scene.time.start_s + scene::chosenSpeed(scene) * scene.time.duration_s;
  const double theirs_s = std::max(std::abs(span.from_s), std::abs(span.to_s));
  if (grade.fit || !isFarOff(grade) || !(std::abs(end_s) > 0) || theirs_s < kFar * std::abs(end_s)) return "";
  return fmt::format(
      "the log's times go to {:.4g} s, the film's motion to {:.4g} s; t must be the motion time in seconds",
      theirs_s, end_s);
}

/// Returns a note on the errors of a log with its first row moved to time 0. Empty if that motion is too long,
/// too.
std::string noteFromFirstRow(const MotionMaker& maker, const TrajectoryTable& theirs) {
  try {
    return firstRowNote(gradeFromZero(maker, theirs));
  } catch (const core::Error&) {
    return "";  // the caller reports the error for the log as written
  }
}

std::size_t farthestRow(const TrajectoryTable& theirs) {
  std::size_t farthest = 0;
  for (std::size_t row = 1; row < theirs.rows(); ++row)
    if (std::abs(theirs.t_s(row)) > std::abs(theirs.t_s(farthest))) farthest = row;
  return farthest;
}

/// Returns the motion of the scene over all times of the log.
/// @throws core::Error with the place in the log of the time farthest from 0; see gradeAgainst()
std::unique_ptr<const physics::Motion> motionOver(const MotionMaker& maker, const TrajectoryTable& theirs) {
  const physics::TimeSpan span = spanOf(theirs);
  try {
    return maker(span);
  } catch (const core::Error& error) {
    if (error.kind() != core::ErrorKind::kLimit) throw;
    const bool onClock = span.from_s > span.to_s - span.from_s;
    const std::string note = onClock ? noteFromFirstRow(maker, theirs) : "";
    throw core::Error(error.kind(),
                      note.empty()
                          ? error.message()
                          : fmt::format("{}; the log's t starts at {} s: {}", error.message(), span.from_s, note),
                      theirs.placeOfTime(farthestRow(theirs)));
  }
}

}  // namespace

Grade gradeAgainst(const scene::Scene& scene, const TrajectoryTable& theirs) {
  const MotionMaker maker = [&](const physics::TimeSpan& wanted) {
    return scene::makeMotion(scene, wanted.from_s, wanted.to_s);
  };
  const auto motion = motionOver(maker, theirs);
  Grade made = grade(*motion, theirs, maker);
  if (std::string note = timeNote(made, scene, spanOf(theirs)); !note.empty())
    made.notes.push_back(std::move(note));
  return made;
}

double attitudeLimit_rad(std::string_view name, std::string_view word) {
  const std::string text(word);
  const auto number = core::parseNumber(text);
  const auto quantity =
      number ? scene::Quantity{*number, ""} : scene::parseQuantity(text, scene::Dimension::kAngle);
  if (quantity.ok() && quantity.value >= 0) return quantity.value;
  throw core::usageError(fmt::format("{} '{}': must be an angle of at least 0, such as 1e-6 (rad) or '0.1 deg'",
                                     name, core::printable(text)));
}

}  // namespace poinsot::reference
