// SPDX-License-Identifier: Apache-2.0
#include "cli/dry_run.h"

#include <fmt/format.h>

#include "app/assembly.h"
#include "app/scene_composer.h"
#include "app/work_folder.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/text.h"

namespace poinsot::cli {
namespace {

using Segments = std::vector<app::FrameRange>;

std::string nameText(const app::RenderRequest& request) { return core::printable(request.target.path.string()); }

int describePrinted(const app::RenderRequest& request, const scene::Output& output) {
  const auto [width_mm, dpi] = *request.form.print;
  writeOut(fmt::format("{}: {:.4g} x {:.4g} mm at {:.4g} dpi, {}x{} pixels\n", nameText(request), width_mm,
                       width_mm * output.height / output.width, dpi, output.width, output.height));
  return kDone;
}

std::int64_t framesThere(const app::RenderRequest& request, const Segments& segments) {
  if (app::isFinished(*request.job, request.target.path)) return app::framesIn(segments);
  const app::SegmentRecords records(app::workFolderOf(request.target.path), request.target);
  std::int64_t frames = 0;
  for (const app::FrameRange& segment : segments)
    if (records.stateOf(segment, request.job->job) == app::SegmentState::kDone) frames += segment.count();
  return frames;
}

/// ", 60 frames are there already"
std::string thereText(const app::RenderRequest& request, const Segments& segments) {
  const bool goesOn = request.job && (request.shard || request.resume);
  return goesOn ? fmt::format(", {} frames are there already", framesThere(request, segments)) : "";
}

}  // namespace

int describe(const app::RenderRequest& request, const scene::Scene& scene) {
  app::composerOf(request.scene, scene);  // what the motion lacks is found here
  if (request.form.print) return describePrinted(request, scene.output);
  const Segments segments = request.segments();
  const std::int64_t own = app::framesIn(segments), all = request.frames.count();
  const auto& shard = request.shard;
  writeOut(fmt::format("{}{}: {}{} frame{} ({}-{}), {}x{}, {} frames/s, {} segment{}{}\n", nameText(request),
                       shard ? fmt::format(", shard {}/{}", shard->k, shard->n) : "", own,
                       shard ? fmt::format(" of {}", all) : "", all == 1 ? "" : "s", request.frames.first,
                       request.frames.last, scene.output.width, scene.output.height,
                       core::toString(scene.time.fps), segments.size(), segments.size() == 1 ? "" : "s",
                       thereText(request, segments)));
  return kDone;
}

}  // namespace poinsot::cli
