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

/// Words of the command line common to `render` and `still`, as typed.
struct RenderOptions : SceneOptions {
  std::string output, size, quality, fps, trace;
  int jobs = 0;
  int view = 0;  ///< counted from 1; 0: all of them
  bool force = false, quiet = false, reproducible = false, stats = false, dryRun = false, loop = false;
  std::string progress = "auto", backend = "auto";
  std::optional<request::SweepRequest> sweep;  ///< by the command
};

/// Declares those that every process of a render must be told: size, quality, back end, what may be replaced.
void addLookOptions(const Command& command, RenderOptions& options);

/// Declares those of how pictures are made: size, quality, workers, what may be replaced, back end, dry run.
void addPictureOptions(const Command& command, RenderOptions& options);

/// Declares --view.
void addViewOption(const Command& command, RenderOptions& options);

/// Declares them all, except for the output and --fps.
void addRenderOptions(const Command& command, RenderOptions& options);

/// "640x360".
/// @throws core::Error(kUsage) when it is no such thing, core::Error(kLimit) beyond the limits of a picture.
image::PixelSize parseSize(const std::string& text, const scene::Limits& limits);

/// Reads and checks the scene file, with -q, -D, --fps and --loop above it, the later above the earlier.
/// @throws scene::SceneErrors naming options as typed; core::Error(kScene, kUsage, kLimit)
request::RequestedScene requestedScene(const RenderOptions& options);
/// The same with what is allowed, where several scenes are read by one command.
request::RequestedScene requestedScene(const RenderOptions& options, const scene::Allowance& allowance);

gl::Backend requestedBackend(const RenderOptions& options);

}  // namespace poinsot::cli
