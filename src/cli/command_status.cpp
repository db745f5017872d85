// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/assembly.h"
#include "app/json_text.h"
#include "app/work_folder.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/error.h"
#include "core/text.h"
#include "output/film.h"

namespace poinsot::cli {
namespace {

using app::SegmentState;

struct StatusOptions {
  std::string output;
  bool json = false, shards = false;
};

/// Words for a state, in the order that they are told in.
struct StateWord {
  SegmentState state;
  const char* word;
};
constexpr StateWord kStates[] = {{SegmentState::kDone, "done"},
                                 {SegmentState::kMissing, "missing"},
                                 {SegmentState::kStale, "stale"},
                                 {SegmentState::kCorrupt, "corrupt"}};

/// The shards that have a segment which is not done.
std::vector<int> openShards(const app::JobStatus& status, int shards) {
  std::vector<int> open;
  for (int k = 1; k <= shards; ++k)
    for (auto i = static_cast<std::size_t>(k - 1); i < status.states.size(); i += static_cast<std::size_t>(shards))
      if (status.states[i] != SegmentState::kDone) {
        open.push_back(k);
        break;
      }
  return open;
}

/// "2,7-9", as Slurm's --array takes it.
std::string rangeText(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

std::string jsonText(const StatusOptions& options, const app::JobFile& job, const app::JobStatus& status) {
  nlohmann::ordered_json json{{"output", app::utf8FromBytes(options.output)},
                              {"complete", status.complete()},
                              {"frames", {job.frames.first, job.frames.last}},
                              {"segment_frames", job.segmentFrames},
                              {"shards", job.shards}};
  for (const auto& [state, word] : kStates) {
    json[word] = nlohmann::ordered_json::array();
    for (const app::FrameRange& segment : status.in(state)) json[word].push_back({segment.first, segment.last});
  }
  json["shards_to_run"] = rangeText(openShards(status, job.shards));
  return json.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string plainText(const StatusOptions& options, const app::JobFile& job, const app::JobStatus& status) {
  std::string counts, lines;
  for (const auto& [state, word] : kStates) {
    const auto segments = status.in(state);
    if (state == SegmentState::kDone || !segments.empty())
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", segments.size(), word);
    if (state != SegmentState::kDone && !segments.empty())
      lines += fmt::format("{}: frames {}\n", word, app::framesText(segments, 20));
  }
  if (job.shards > 1 && !status.complete())
    lines += fmt::format("shards to run: {} of {}\n", rangeText(openShards(status, job.shards)), job.shards);
  return fmt::format("{}: {} segments: {}\n{}", core::printable(options.output), status.segments.size(), counts,
                     lines);
}

int status(const StatusOptions& options) {
  const auto target = app::parseTarget(options.output);
  const auto folder = app::workFolderOf(target.path);
  const auto job = app::readJobFile(folder, target);
  if (!job && target.kind == app::OutputKind::kFilm && output::isOwnFilm(target.path)) {
    if (!options.shards)
      writeOut(options.json ? "{\"complete\": true}\n"
                            : fmt::format("{}: complete\n", core::printable(options.output)));
    return kDone;
  }
  if (!job)
    throw core::Error(core::ErrorKind::kIo,
                      fmt::format("{}: no render of it is under way here", core::printable(options.output)));
  const app::JobStatus state = app::statusOf(folder, *job, target);
  if (options.shards)
    writeOut(rangeText(openShards(state, job->shards)) + "\n");
  else
    writeOut(options.json ? jsonText(options, *job, state) : plainText(options, *job, state));
  return state.complete() ? kDone : kNo;
}

}  // namespace

void addStatus(CLI::App& program, Action& chosen) {
  auto options = std::make_shared<StatusOptions>();
  CLI::App* command =
      program.add_subcommand("status", "say how far a film is: which frames are done, missing, stale, corrupt");
  command->add_option("OUTPUT", options->output, "what the render was told with -o")->required();
  command->add_flag("--json", options->json, "the same for a program");
  command->add_flag("--shards", options->shards,
                    "only the shards that have work left, such as 2,7-9: for a job array");
  command->footer(
      "Exit code 1 where something is left to do.\n"
      "Example:\n"
      "  poinsot status out/film.mp4");
  command->callback([options, &chosen] { chosen = [options] { return status(*options); }; });
}

}  // namespace poinsot::cli
