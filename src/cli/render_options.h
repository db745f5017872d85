// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/output_target.h"
#include "app/progress.h"
#include "app/scene_request.h"
#include "gl/offscreen_context.h"
#include "image/image.h"

namespace CLI {
class App;
}

namespace poinsot::cli {

/// Words of the command line common to `render` and `still`, as typed.
struct RenderOptions {
  std::string scene, output, size, quality;
  std::vector<std::string> overrides;
  int jobs = 0;
  bool force = false, quiet = false, reproducible = false, stats = false, dryRun = false;
  std::string progress = "auto", backend = "auto";
};

/// Declares them.
void addRenderOptions(CLI::App& command, RenderOptions& options);

/// "640x360".
/// @throws core::Error(kUsage) when it is no such thing, core::Error(kLimit) beyond the limits of a picture.
image::PixelSize parseSize(const std::string& text);

/// Reads the scene file, with -q and -D in their order of precedence (-q below -D, both above the file).
/// @throws core::Error(kScene, kUsage, kLimit)
app::SceneRequest requestedScene(const RenderOptions& options);

/// -o, or out/NAME with the extension.
/// @throws core::Error(kUsage)
app::OutputTarget requestedTarget(const RenderOptions& options, const std::string& sceneName,
                                  const std::string& extension);

gl::Backend requestedBackend(const RenderOptions& options);

}  // namespace poinsot::cli
