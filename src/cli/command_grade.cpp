// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "app/grade.h"
#include "app/grade_text.h"
#include "app/trajectory_number.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "core/error.h"
#include "core/text.h"
#include "scene/make_motion.h"
#include "scene/units.h"

namespace poinsot::cli {
namespace {

struct GradeOptions : SceneOptions {
  std::string theirs, limit;
  bool json = false;
};

/// --max-attitude-error: rad, or with a unit.
std::optional<double> limit_rad(const std::string& word) {
  if (word.empty()) return std::nullopt;
  const auto number = app::parseNumber(word);
  const auto quantity =
      number ? scene::Quantity{*number, ""} : scene::parseQuantity(word, scene::Dimension::kAngle);
  if (quantity.ok() && quantity.value >= 0) return quantity.value;
  throw core::Error(
      core::ErrorKind::kUsage,
      fmt::format("--max-attitude-error '{}': an angle that is not negative, such as 1e-6 (rad) or '0.1 deg'",
                  core::printable(word)));
}

/// Returns whether the attitude keeps to the limit; if not, standard error says by how much it is off and when.
/// @throws core::Error(kIo) if the file has no attitude.
bool within(const app::Grade& grade, double limit_rad, const std::string& fileName) {
  const auto& errors = grade.quantity("attitude").errors;
  if (!errors)
    throw core::Error(core::ErrorKind::kIo, "no columns q_w, q_x, q_y, q_z for --max-attitude-error to judge",
                      core::SourceLocation{core::printable(fileName), 0, 0});
  if (errors->largest <= limit_rad) return true;
  writeErr(
      fmt::format("poinsot: {}: the attitude is off by {:.3g} rad at t = {:.6g} s, --max-attitude-error allows "
                  "{:.3g} rad\n",
                  core::printable(fileName), errors->largest, errors->largestAt_s, limit_rad));
  return false;
}

bool isFarOff(const app::Grade& grade) {
  constexpr double kFarOff = 0.1;  // rad, or of omega
  return std::ranges::any_of(grade.quantities, [](const app::GradedQuantity& quantity) {
    return quantity.errors && quantity.errors->rms > kFarOff;
  });
}

/// Of a motion that is not ours, times far beyond the film's may be milliseconds, or another clock's.
std::string timeNote(const app::Grade& grade, const scene::Scene& scene, const physics::TimeSpan& span) {
  constexpr double kFar = 20;
  const double end_s = scene.time.start_s + scene::chosenSpeed(scene) * scene.time.duration_s;
  const double theirs_s = std::max(std::abs(span.from_s), std::abs(span.to_s));
  if (grade.fit || !isFarOff(grade) || !(std::abs(end_s) > 0) || theirs_s < kFar * std::abs(end_s)) return "";
  return fmt::format(
      "their times go to {:.4g} s, the film's motion to {:.4g} s; t is the motion's time in seconds", theirs_s,
      end_s);
}

/// Returns the errors of a log whose first row is taken at motion time 0; empty if the motion is too long from
/// there, too.
std::string firstRowNote(const app::MotionMaker& maker, const app::TrajectoryTable& theirs) {
  try {
    return app::firstRowNote(app::gradeFromZero(maker, theirs));
  } catch (const core::Error&) {
    return "";  // what is wrong with the log as it is written is reported instead
  }
}

/// Makes the motion over their times. @throws core::Error(kLimit) if a driven motion is too long; for a log on a
/// clock's time, far from 0, the message also gives its errors from the first row on.
std::unique_ptr<const physics::Motion> motionOver(const app::MotionMaker& maker,
                                                  const app::TrajectoryTable& theirs) {
  const physics::TimeSpan span = app::spanOf(theirs);
  try {
    return maker(span);
  } catch (const core::Error& error) {
    if (error.kind() != core::ErrorKind::kLimit || span.from_s <= span.to_s - span.from_s) throw;
    const std::string note = firstRowNote(maker, theirs);
    if (note.empty()) throw;
    throw core::Error(error.kind(),
                      fmt::format("{}; their t starts at {} s: {}", error.message(), span.from_s, note));
  }
}

int gradeTheirs(const GradeOptions& options) {
  const auto limit = limit_rad(options.limit);
  const scene::Scene scene = loadScene(options);
  const app::TrajectoryTable theirs = app::readTrajectoryTable(options.theirs);
  const physics::TimeSpan span = app::spanOf(theirs);
  const app::MotionMaker maker = [&](const physics::TimeSpan& wanted) {
    return scene::makeMotion(scene, wanted.from_s, wanted.to_s);
  };
  const auto motion = motionOver(maker, theirs);
  app::Grade grade = app::grade(*motion, theirs, maker);
  if (std::string note = timeNote(grade, scene, span); !note.empty()) grade.notes.push_back(std::move(note));
  writeOut(options.json ? app::gradeJson(grade, options.theirs, scene.name) : app::gradeTable(grade));
  return !limit || within(grade, *limit, options.theirs) ? kDone : kNo;
}

}  // namespace

void addGrade(CLI::App& program, Action& chosen) {
  auto options = std::make_shared<GradeOptions>();
  CLI::App* command =
      program.add_subcommand("grade", "say how far another engine's trajectory is off, and from when on");
  addSceneOptions(*command, *options);
  command
      ->add_option("THEIRS", options->theirs,
                   "CSV with the columns of `poinsot trajectory`, any order; t and q or omega_B at least")
      ->required();
  command
      ->add_option("--max-attitude-error", options->limit,
                   "exit 1 if the attitude is off by more, rad or with a unit")
      ->type_name("ANGLE")
      ->check(notEmpty());
  command->add_flag("--json", options->json, "as a JSON object");
  command->footer(
      "Example:\n"
      "  poinsot grade scenes/football.toml mine.csv --max-attitude-error '0.1 deg'\n"
      "Exit code 0 when graded, however bad; 1 only beyond --max-attitude-error.");
  command->callback([options, &chosen] {
    chosen = [options] {
      return confined(
          *options,
          [&] {
            Reach reach{{options->scene}, options->assetRoots};
            reach.inputs.push_back(options->theirs);
            return reach;
          },
          [&] { return gradeTheirs(*options); });
    };
  });
}

}  // namespace poinsot::cli
