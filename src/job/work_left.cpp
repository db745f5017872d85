// SPDX-License-Identifier: Apache-2.0
#include "job/work_left.h"

#include <fmt/format.h>
#include <filesystem>
#include <system_error>

#include "core/shell_word.h"
#include "core/text.h"
#include "job/work_folder.h"
#include "output/film.h"

namespace poinsot::job {

WorkLeft workLeft(const JobRecord& job, const JobStatus& status, int shards, const request::OutputTarget& output) {
  WorkLeft left;
  if (isFinished(job, output.path)) return left;
  left.joining = output.kind == request::OutputKind::kFilm || std::filesystem::exists(workFolderOf(output.path));
  const auto count = static_cast<std::size_t>(shards);
  std::vector<bool> open(count);
  for (std::size_t i = 0; i < status.states.size(); ++i)
    if (status.states[i] != SegmentState::kDone) open[i % count] = true;
  for (std::size_t k = 0; k < count; ++k)
    if (open[k]) left.shards.push_back(static_cast<int>(k + 1));
  return left;
}

std::string shardsText(const std::vector<int>& shards) {
  std::string text;
  for (std::size_t i = 0; i < shards.size();) {
    std::size_t last = i;
    while (last + 1 < shards.size() && shards[last + 1] == shards[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", shards[i]);
    if (last > i) text += fmt::format("-{}", shards[last]);
    i = last + 1;
  }
  return text;
}

bool isReadyFilm(const request::OutputTarget& output) {
  return output.kind == request::OutputKind::kFilm && output::isWholeFilm(output.path);
}

namespace {

namespace fs = std::filesystem;

std::string renderText(const request::OutputTarget& output) {
  return "poinsot render SCENE -o " + core::printable(core::shellWord(output.path.native()));
}

}  // namespace

std::string nothingUnderWayText(const request::OutputTarget& output, const fs::path& workFolder) {
  std::error_code ignored;
  const std::string render = renderText(output);
  if (fs::is_directory(workFolder, ignored))
    return fmt::format("{}/job.json is missing or damaged; {} --resume writes it again and keeps whole segments",
                       core::printable(workFolder.native()), render);
  if (isReadyFilm(output)) return "the film itself is complete";
  if (output.kind != request::OutputKind::kFilm || !fs::exists(output.path, ignored))
    return "nothing with that name exists; make it: " + render;
  if (output::isOwnFilm(output.path))
    return fmt::format("the film itself was damaged or changed after it was written; {} --resume makes it again",
                       render);
  return fmt::format(
      "the file there was written by another program, or is too damaged to be recognised; {} --force replaces it",
      render);
}

std::string makeText(const JobRecord& job, const JobStatus& status, const request::OutputTarget& output) {
  const WorkLeft left = workLeft(job, status, job.shards, output);
  if (job.shards == 1) return "make them: " + renderText(output) + " --resume";
  const std::string shards = shardsText(left.shards);
  const bool isOne = left.shards.size() == 1;
  return fmt::format("make them: {} --shard {}/{}{}", renderText(output), isOne ? shards : "K", job.shards,
                     isOne ? "" : " for each K of " + shards);
}

}  // namespace poinsot::job
