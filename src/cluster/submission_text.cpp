// SPDX-License-Identifier: Apache-2.0
#include "cluster/submission_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "core/shell_word.h"
#include "core/text.h"
#include "core/version.h"

namespace poinsot::cluster {
namespace {

std::string counted(std::int64_t number, const std::string& noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

}  // namespace

std::string durationText(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", std::ceil(seconds))
                      : fmt::format("{:.0f} min", std::ceil(seconds / 60));
}

std::string filled(std::string_view script, const std::map<std::string, std::string>& values) {
  for (const auto& [name, value] : values) POINSOT_EXPECT(script.find("@" + name + "@") != std::string_view::npos);
  std::string text;
  std::size_t from = 0;
  for (std::size_t at = script.find('@'); at != std::string_view::npos; at = script.find('@', from)) {
    const std::size_t end = std::min(script.find('@', at + 1), script.size());
    const auto value = values.find(std::string(script.substr(at + 1, end - at - 1)));
    const bool isName = end < script.size() && value != values.end();
    text.append(script, from, at - from).append(isName ? value->second : "@");
    from = isName ? end + 1 : at + 1;
  }
  return text.append(script.substr(from));
}

std::string statusCommand(const Submission& submission) {
  if (submission.assemble.empty()) return leftCommand(submission, core::shellWords(submission.program));
  const auto output = (submission.folder / submission.output.path).lexically_normal();
  return core::shellWords(submission.program) + " status " + core::shellWord(output.string());
}

std::string whatText(const Submission& submission, const std::string& how) {
  const Division& division = submission.division;
  return fmt::format(
      "# {}\n"
      "# {} in {}, made by {}{}.\n"
      "# Estimate: {:.2g} s of CPU time per frame, {} per task. Printed by poinsot {}; see poinsot submit --help.",
      core::shellWord(submission.output.path.string()), counted(submission.frames, "frame"), submission.pieces,
      counted(division.shards, "task"), how, division.frame_s, durationText(division.task_s), core::version());
}

std::string lastStep(const Submission& submission) {
  return submission.assemble.empty() ? "checks that all films exist" : "joins what they made";
}

std::string setupLine(const std::string& command) { return "eval " + core::shellWord(command); }

std::vector<std::string> placeLines(const Submission& submission) {
  std::vector<std::string> lines{fmt::format("cd -- {} || exit 4", core::shellWord(submission.folder.string()))};
  for (const std::string& command : submission.setup) lines.push_back(setupLine(command) + " || exit");
  lines.push_back(fmt::format("poinsot=({})", core::shellWords(submission.program)));
  lines.emplace_back("[[ $POINSOT ]] && poinsot=(\"$POINSOT\")");
  return lines;
}

std::string placeText(const Submission& submission, const std::string& indent) {
  return indent + core::joined(placeLines(submission), "\n" + indent);
}

std::string shardCommand(const Submission& submission, const std::string& shard, const std::string& program) {
  return fmt::format("{} {} --shard \"{}/{}\"", program, core::shellWords(submission.render), shard,
                     submission.division.shards);
}

std::string leftCommand(const Submission& submission, const std::string& program) {
  return fmt::format("{} {} --shards-left {}", program, core::shellWords(submission.render),
                     submission.division.shards);
}

std::string joinCommand(const Submission& submission, const std::string& program) {
  if (submission.assemble.empty()) return leftCommand(submission, program);
  return fmt::format("{} >/dev/null 2>&1 || {} {}", leftCommand(submission, program), program,
                     core::shellWords(submission.assemble));
}

}  // namespace poinsot::cluster
