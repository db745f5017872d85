// SPDX-License-Identifier: Apache-2.0
#include "cli/dry_run.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/text.h"
#include "gl/shader_cache.h"
#include "job/assembly.h"
#include "job/work_folder.h"
#include "job/work_left.h"
#include "request/requested_scene.h"

namespace poinsot::cli {

namespace {

using Segments = std::vector<request::FrameRange>;

std::string nameText(const job::RenderRequest& request) { return core::printable(request.target.path.string()); }

int describePrinted(const job::RenderRequest& request, const scene::Output& output) {
  const request::PrintSize& print = *request.form.print;
  writeOut(fmt::format("{}: {:.4g} x {:.4g} mm at {:.4g} dpi, {}x{} pixels\n", nameText(request), print.width_mm,
                       print.width_mm * output.height / output.width, print.dpi, output.width, output.height));
  return kDone;
}

std::int64_t framesThere(const job::RenderRequest& request, const Segments& segments) {
  if (job::isFinished(*request.record, request.target.path)) return request::framesIn(segments);
  const job::SegmentRecords records(job::workFolderOf(request.target.path), request.target);
  std::int64_t frames = 0;
  for (const request::FrameRange& segment : segments)
    if (records.stateOf(segment, request.record->digest) == job::SegmentState::kDone) frames += segment.count();
  return frames;
}

std::string thereText(const job::RenderRequest& request, const Segments& segments) {
  const bool goesOn = request.record && (request.shard || request.resume);
  return goesOn ? fmt::format(", {} frames already exist", framesThere(request, segments)) : "";
}

job::WorkLeft leftIn(const job::RenderRequest& request, int shards) {
  const auto folder = job::workFolderOf(request.target.path);
  return job::workLeft(*request.record, job::statusOf(folder, *request.record, request.target), shards,
                       request.target);
}

}  // namespace

int describe(const job::RenderRequest& request) {
  const scene::Scene& scene = request.scene.scene;
  request::composerOf(request.scene);  // throws if the scene shows something that its motion lacks
  if (request.form.print) return describePrinted(request, scene.output);
  const Segments segments = request.segments();
  const std::int64_t own = request::framesIn(segments), all = request.frames.count();
  const auto& shard = request.shard;
  writeOut(fmt::format("{}{}: {}{} frame{} ({}-{}), {}x{}, {} frames/s, {} segment{}{}\n", nameText(request),
                       shard ? fmt::format(", shard {}/{}", shard->k, shard->n) : "", own,
                       shard ? fmt::format(" of {}", all) : "", all == 1 ? "" : "s", request.frames.first,
                       request.frames.last, scene.output.width, scene.output.height,
                       core::toString(scene.time.fps), segments.size(), segments.size() == 1 ? "" : "s",
                       thereText(request, segments)));
  return kDone;
}

bool isComplete(const job::RenderRequest& request) { return leftIn(request, 1).none(); }

int listShardsLeft(const job::RenderRequest& request) {
  const job::WorkLeft left = leftIn(request, request.shard->n);
  if (left.none())
    writeErr(fmt::format("poinsot: {} is complete\n", core::printable(request.target.path.string())));
  else
    writeOut(job::shardsText(left.shards) + "\n");
  return left.none() ? kDone : kNo;
}

bool isShardOfFinishedFilm(const job::RenderRequest& request) {
  return request.shard && job::isFinished(*request.record, request.target.path);
}

std::string shaderCacheNote(const job::RenderRequest& request) {
  if (!request.shard || gl::isShaderCacheOff() || !gl::shaderCacheFolder(request.reproducible).empty()) return "";
  return "poinsot: note: each shard compiles its shaders again, which takes up to 3 s, because there is no folder "
         "for a shader cache; set HOME or POINSOT_CACHE to a folder of your own\n";
}

}  // namespace poinsot::cli
