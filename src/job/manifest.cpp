// SPDX-License-Identifier: Apache-2.0
#include "job/manifest.h"

#include <nlohmann/json.hpp>
#include <set>

#include "core/json.h"
#include "core/version.h"
#include "job/segment_record.h"

namespace poinsot::job {
namespace {

using Json = nlohmann::ordered_json;
using std::filesystem::path;

Json inputsOf(const JobRecord& job) {
  Json inputs = Json::array();
  for (const scene::InputFile& input : job.inputs)
    inputs.push_back({{"path", core::utf8FromBytes(input.path)}, {"sha256", core::toHex(input.digest)}});
  return inputs;
}

Json toJson(const RecordedFile& file) {
  return {{"path", core::utf8FromBytes(file.path.native())}, {"bytes", file.bytes}, {"sha256", file.sha256}};
}

Json toJson(const RenderSummary& summary) {
  using core::Step;
  const Statistics& s = summary.spent;
  Json steps = Json::object();
  for (std::size_t i = 0; i < core::kSteps; ++i)
    steps[core::nameOf(static_cast<Step>(i))] = s.steps[static_cast<Step>(i)];
  return {{"wall_s", summary.wall_s},
          {"cpu_s", s.cpu_s},
          {"workers", s.workers},
          {"frames_made", s.frames},
          {"frames_reused", summary.reused},
          {"compose_s", s.steps.sum_s(Step::kSimulate, Step::kCompose)},
          {"render_s", s.steps.sum_s(Step::kDraw, Step::kResolve)},
          {"read_s", s.steps[Step::kRead]},
          {"text_s", s.steps[Step::kText]},
          {"convert_s", s.steps[Step::kConvert]},
          {"encode_s", s.steps.sum_s(Step::kEncode, Step::kWrite)},
          {"steps_s", steps},
          {"peak_memory_bytes", s.peakMemory_bytes}};
}

}  // namespace

output::FileKind manifestKind() { return output::textKind("a manifest", "{\n \"poinsot\": \""); }

std::string manifestText(const path& workFolder, const JobRecord& job, const request::OutputTarget& target,
                         const path& film, const RenderSummary& summary) {
  Json digests = Json::object(), files = Json::array();
  std::set<std::string> renderers;
  const SegmentRecords records(workFolder, target);
  for (const request::FrameRange& segment : job.segments()) {
    const auto record = records.find(segment);
    if (!record) continue;  // file was removed or damaged after the segment was completed
    for (std::int64_t k = segment.first; k <= segment.last; ++k)
      digests[std::to_string(k)] = record->digests[static_cast<std::size_t>(k - segment.first)];
    renderers.insert(record->renderer);
    if (job.kind == request::OutputKind::kSequence)
      for (const RecordedFile& frame : record->files) files.push_back(toJson(frame));
  }
  if (job.kind == request::OutputKind::kFilm) {
    RecordedFile whole = recordOf(film);
    whole.path = target.path;
    files.push_back(toJson(whole));
  }
  const Json manifest{{"poinsot", core::version()},
                      {"title", job.title},
                      {"scene_sha256", job.scene},
                      {"inputs", inputsOf(job)},
                      {"settings", Json::parse(job.settings)},
                      {"job_sha256", job.digest},
                      {"renderers", renderers},
                      {"frames", {job.frames.first, job.frames.last}},
                      {"segment_frames", job.segmentFrames},
                      {"files", std::move(files)},
                      {"frame_digests", std::move(digests)},
                      {"spent", toJson(summary)}};
  return manifest.dump(1) + "\n";
}

}  // namespace poinsot::job
