// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "core/error.h"
#include "core/text.h"
#include "reference/grade_text.h"
#include "reference/scene_grade.h"

namespace poinsot::cli {
namespace {

struct GradeOptions : SceneOptions {
  std::string theirs, limit;
  bool json = false;
};

/// Checks that the attitude error stays within the limit. If not, prints the error and its time on stderr, and
/// returns false.
/// @throws core::Error(kIo) if the file has no attitude.
bool within(const reference::Grade& grade, double limit_rad, const std::string& fileName) {
  const auto& errors = grade.quantity("attitude").errors;
  if (!errors)
    throw core::Error(core::ErrorKind::kIo, "--max-attitude-error needs the columns q_w, q_x, q_y, q_z",
                      core::SourceLocation{core::printable(fileName), 0, 0});
  if (errors->largest <= limit_rad) return true;
  writeErr(
      fmt::format("poinsot: {}: the attitude is off by {:.3g} rad at t = {:.6g} s, --max-attitude-error allows "
                  "{:.3g} rad\n",
                  core::printable(fileName), errors->largest, errors->largestAt_s, limit_rad));
  return false;
}

int gradeTheirs(const GradeOptions& options) {
  const bool limited = !options.limit.empty();
  const double limit_rad = limited ? reference::attitudeLimit_rad("--max-attitude-error", options.limit) : 0;
  const scene::Scene scene = loadScene(options);
  const reference::Grade grade = reference::gradeAgainst(scene, reference::readTrajectoryTable(options.theirs));
  writeOut(options.json ? reference::gradeJson(grade, options.theirs, scene.name) : reference::gradeTable(grade));
  return !limited || within(grade, limit_rad, options.theirs) ? kDone : kNo;
}

}  // namespace

void addGrade(const Command& program) {
  auto options = std::make_shared<GradeOptions>();
  const Command command =
      program.command("grade", "measure how far another engine's trajectory is off, and since when");
  addSceneOptions(command, *options);
  command
      .option("THEIRS", options->theirs,
              "CSV with the columns of `poinsot trajectory` in any order: at least t, and q or omega_B")
      .required();
  command
      .option("--max-attitude-error", options->limit,
              "exit with 1 if the attitude is off by more than ANGLE, in rad or with a unit")
      .type("ANGLE")
      .notEmpty();
  command.flag("--json", options->json, "print the grade as a JSON object");
  command.footer(
      "Example:\n"
      "  poinsot grade scenes/football.toml mine.csv --max-attitude-error '0.1 deg'\n"
      "Exit code 0 if the trajectory was graded, even if it is bad; 1 only if it exceeds --max-attitude-error.");
  command.does({[options] { return gradeTheirs(*options); }, options.get(),
                [options] {
                  FileAccess access{{options->scene}, options->assetRoots};
                  access.inputs.push_back(options->theirs);
                  return access;
                }});
}

}  // namespace poinsot::cli
