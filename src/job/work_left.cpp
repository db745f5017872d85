// SPDX-License-Identifier: Apache-2.0
#include "job/work_left.h"

#include <fmt/format.h>

#include <filesystem>

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

}  // namespace poinsot::job
