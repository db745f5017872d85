// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/error.h"
#include "core/json.h"
#include "core/shell_word.h"
#include "core/text.h"
#include "job/work_folder.h"
#include "job/work_left.h"
#include "output/png_sequence.h"

namespace poinsot::cli {
namespace {

using job::SegmentState;

struct StatusOptions {
  std::string output;
  bool json = false, shards = false;
};

/// State of a segment, and its name in the output.
struct StateWord {
  SegmentState state;
  const char* word;
};
constexpr StateWord kStates[] = {{SegmentState::kDone, "done"},
                                 {SegmentState::kMissing, "missing"},
                                 {SegmentState::kStale, "stale"},
                                 {SegmentState::kCorrupt, "corrupt"}};

struct Standing {
  job::JobRecord job;
  job::JobStatus status;
  job::WorkLeft left;
};

using Json = nlohmann::ordered_json;
using Frames = std::vector<request::FrameRange>;

/// Returns the JSON object for an output without segment records. It has all keys, but keys about segments are
/// null or empty.
/// @param whole  whether the film is complete; null for a sequence, because the number of its frames is unknown
Json jsonOfOutput(const StatusOptions& options, const Json& whole) {
  Json json{{"output", core::utf8FromBytes(options.output)},
            {"complete", whole},
            {"joined", whole},
            {"frames", nullptr},
            {"segment_frames", nullptr},
            {"shards", nullptr}};
  for (const auto& [state, word] : kStates) json[word] = Json::array();
  json["shards_to_run"] = "";
  return json;
}

Json jsonOf(const StatusOptions& options, const Standing& standing) {
  const auto& [job, status, left] = standing;
  Json json = jsonOfOutput(options, !left.joining);
  json["complete"] = left.none();
  json["frames"] = {job.frames.first, job.frames.last};
  json["segment_frames"] = job.segmentFrames;
  json["shards"] = job.shards;
  for (const auto& [state, word] : kStates)
    for (const request::FrameRange& segment : status.in(state))
      json[word].push_back({segment.first, segment.last});
  json["shards_to_run"] = job::shardsText(left.shards);
  return json;
}

void print(const Json& json) { writeOut(json.dump(1, ' ', true, Json::error_handler_t::replace) + "\n"); }

/// Returns a line with the next step for the user, such as `assemble`. Empty if the render itself is next, or if
/// nothing is left to do.
std::string leftText(const StatusOptions& options, const Standing& standing) {
  const auto& [job, status, left] = standing;
  if (status.complete() && left.joining)
    return fmt::format("not joined yet; run: poinsot assemble {}\n", core::shellWord(options.output));
  if (left.shards.empty() || job.shards == 1) return "";
  return fmt::format("shards to run: {} of {}\n", job::shardsText(left.shards), job.shards);
}

std::string plainText(const StatusOptions& options, const Standing& standing) {
  const job::JobStatus& status = standing.status;
  const bool film = standing.job.kind == request::OutputKind::kFilm;
  std::string counts, lines;
  for (const auto& [state, word] : kStates) {
    const auto segments = status.in(state);
    if (state == SegmentState::kDone || !segments.empty())
      counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", segments.size(), word);
    if (state != SegmentState::kDone && !segments.empty())
      lines += fmt::format("{}: frames {}\n", word, job::framesText(segments, 20));
  }
  return fmt::format("{}: {}{} segments: {}\n{}{}", core::printable(options.output),
                     film && standing.left.none() ? "complete; " : "", status.segments.size(), counts, lines,
                     leftText(options, standing));
}

/// Prints the status of a film that has no segments left. Returns the exit code.
int statusOfFilm(const StatusOptions& options, const std::filesystem::path& film) {
  const bool whole = output::isWholeFilm(film);
  if (options.json)
    print(jsonOfOutput(options, whole));
  else if (!options.shards)
    writeOut(fmt::format(
        "{}: {}\n", core::printable(options.output),
        whole ? "complete" : "damaged or changed after it was written; render with --resume makes it again"));
  return whole ? kDone : kNo;
}

Frames rangesOf(const std::vector<std::int64_t>& frames) {
  Frames ranges;
  for (const std::int64_t k : frames)
    if (!ranges.empty() && ranges.back().last + 1 == k)
      ranges.back().last = k;
    else
      ranges.push_back({k, k});
  return ranges;
}

Json jsonOfFrames(const StatusOptions& options, const Frames& there, const Frames& gaps) {
  Json json = jsonOfOutput(options, nullptr);
  json["frames"] = {there.front().first, there.back().last};
  for (const request::FrameRange& range : there) json["done"].push_back({range.first, range.last});
  for (const request::FrameRange& range : gaps) json["missing"].push_back({range.first, range.last});
  return json;
}

/// Prints which frames of a sequence exist if there is no work folder. The total number of frames is then unknown.
/// Returns the exit code.
int statusOfFrames(const StatusOptions& options, const Frames& there) {
  Frames gaps;
  for (std::size_t i = 1; i < there.size(); ++i) gaps.push_back({there[i - 1].last + 1, there[i].first - 1});
  if (options.json)
    print(jsonOfFrames(options, there, gaps));
  else if (options.shards)
    writeOut("\n");
  else
    writeOut(
        fmt::format("{}: frames {} exist\n"
                    "{}to make more frames of the scene: poinsot render SCENE -o {} --resume\n",
                    core::printable(options.output), job::framesText(there, 20),
                    gaps.empty() ? "" : fmt::format("missing: frames {}\n", job::framesText(gaps, 20)),
                    core::printable(core::shellWord(options.output))));
  return gaps.empty() ? kDone : kNo;
}

Frames framesThere(const request::OutputTarget& target) {
  std::error_code ignored;
  const bool isRecorded = std::filesystem::exists(job::workFolderOf(target.path), ignored);
  if (isRecorded || target.kind != request::OutputKind::kSequence) return {};
  return rangesOf(output::framesThere(output::FramePattern(target.path.string())));
}

int status(const StatusOptions& options) {
  const auto target = request::parseTarget(options.output);
  const auto folder = job::workFolderOf(target.path);
  const auto job = job::readJobRecord(folder, target);
  if (const Frames there = framesThere(target); !there.empty()) return statusOfFrames(options, there);
  if (!job && target.kind == request::OutputKind::kFilm && output::isOwnFilm(target.path))
    return statusOfFilm(options, target.path);
  if (!job)
    throw core::ioError(fmt::format("{}: no render in progress here; {}", core::printable(options.output),
                                    job::nothingUnderWayText(target, folder)));
  const job::JobStatus state = job::statusOf(folder, *job, target);
  // A finished film may still have some segments, if the run was killed during cleanup.
  if (!state.complete() && job::isFinished(*job, target.path)) return statusOfFilm(options, target.path);
  const Standing standing{*job, state, job::workLeft(*job, state, job->shards, target)};
  if (options.shards)
    writeOut(job::shardsText(standing.left.shards) + "\n");
  else if (options.json)
    print(jsonOf(options, standing));
  else
    writeOut(plainText(options, standing));
  return standing.left.none() ? kDone : kNo;
}

}  // namespace

void addStatus(const Command& program) {
  auto options = std::make_shared<StatusOptions>();
  const Command command =
      program.command("status", "show how far a film is: which frames are done, missing, stale, corrupt");
  command.option("OUTPUT", options->output, "the output that the render was given with -o").required();
  command.flag("--json", options->json, "print the status as a JSON object");
  command.flag("--shards", options->shards,
               "print only the shards that have segments to make, such as 2,7-9, for a job array");
  command.footer(
      "Exit code 1 if something is left to do, even only the joining; 4 if no part of the output exists.\n"
      "The length of a numbered sequence without a work folder is unknown, so the exit code is 0 if its frames\n"
      "have no gap. If the scene has more frames, render --resume makes only the missing ones.\n"
      "Example:\n"
      "  poinsot status out/film.mp4");
  command.does({[options] { return status(*options); }});
}

}  // namespace poinsot::cli
