// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cli/scene_options.h"
#include "gl/offscreen_context.h"
#include "image/image.h"
#include "job/progress.h"
#include "request/output_target.h"
#include "request/requested_scene.h"

namespace poinsot::cli {

/// Options of the commands that render, as the user typed them.
struct RenderOptions : SceneOptions {
  std::string output, size, quality, fps, trace;
  int jobs = 0;
  int view = 0;  ///< number of the view to draw, from 1; 0 draws all
  bool force = false, quiet = false, reproducible = false, stats = false, dryRun = false, loop = false;
  std::string progress = "auto", backend = "auto";
  std::string times;  ///< instants of the cells of a sweep; empty for one instant
  std::optional<request::SweepRequest> sweep;
};

/// Declares the options for size, quality, back end and --force, which every process of a render needs.
void addLookOptions(const Command& command, RenderOptions& options);

/// Declares the options of addLookOptions(), and -j, --quiet, --reproducible and --dry-run.
void addPictureOptions(const Command& command, RenderOptions& options);

void addViewOption(const Command& command, RenderOptions& options);

/// Declares all options of a render except -o, --fps and --loop.
void addRenderOptions(const Command& command, RenderOptions& options);

/// Parses a picture size such as "640x360".
/// @throws core::Error(kUsage) if the text is malformed; core::Error(kLimit) if a side is too small or too large
image::PixelSize parseSize(const std::string& text, const scene::Limits& limits);

/// Reads and checks the scene file. The options -q, -D, --fps and --loop override keys of the file. If two of them
/// set the same key, the later one in this list wins.
/// @throws scene::SceneErrors naming options as typed; core::Error(kScene, kUsage, kLimit)
request::RequestedScene requestedScene(const RenderOptions& options);
/// Reads a scene with the given limits, for commands that read several scenes. @param allowance  result of
/// granted()
request::RequestedScene requestedScene(const RenderOptions& options, const scene::Allowance& allowance);

gl::Backend requestedBackend(const RenderOptions& options);

}  // namespace poinsot::cli
