// SPDX-License-Identifier: Apache-2.0
#include "cluster/submission_text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/shell_word.h"
#include "core/version.h"

namespace poinsot::cluster {
namespace {

std::string counted(std::int64_t number, const std::string& noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string durationText(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", std::ceil(seconds))
                      : fmt::format("{:.0f} min", std::ceil(seconds / 60));
}

}  // namespace

std::string statusCommand(const Submission& submission) {
  const auto output = (submission.folder / submission.output.path).lexically_normal();
  return core::shellWords({submission.program.string(), "status", output.string()});
}

std::string whatText(const Submission& submission, const std::string& how) {
  const Division& division = submission.division;
  return fmt::format(
      "# {}\n"
      "# {} in {}, made by {}{}.\n"
      "# Reckoned: {:.2g} s of CPU time a frame, {} a task. Printed by poinsot {}; see poinsot submit --help.\n",
      core::shellWord(submission.output.path.string()), counted(submission.frames, "frame"),
      counted(submission.segments, "segment"), counted(division.shards, "task"), how, division.frame_s,
      durationText(division.task_s), core::version());
}

std::vector<std::string> placeLines(const Submission& submission) {
  return {fmt::format("cd -- {} || exit 4", core::shellWord(submission.folder.string())),
          fmt::format("poinsot=${{POINSOT:-{}}}", core::shellWord(submission.program.string()))};
}

std::string placeText(const Submission& submission, const std::string& indent) {
  std::string text;
  for (const std::string& line : placeLines(submission)) text += indent + line + "\n";
  return text;
}

std::string shardCommand(const Submission& submission, const std::string& shard) {
  return fmt::format("\"$poinsot\" {} --shard \"{}/{}\"", core::shellWords(submission.render), shard,
                     submission.division.shards);
}

std::string leftCommand(const Submission& submission) {
  return fmt::format("\"$poinsot\" {} --shards-left {}", core::shellWords(submission.render),
                     submission.division.shards);
}

std::string joinCommand(const Submission& submission) {
  return fmt::format("{} >/dev/null 2>&1 || \"$poinsot\" {}", leftCommand(submission),
                     core::shellWords(submission.assemble));
}

}  // namespace poinsot::cluster
