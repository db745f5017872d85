// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "job/render_request.h"

namespace poinsot::job {

/// What all workers of a render inherit.
struct WorkerTask {
  const RenderRequest& render;
  std::filesystem::path workFolder;  ///< takes the segments of a film
  int rasterThreads = 0;             ///< llvmpipe's; 0 rasterises in the worker itself

  /// Whether segments that are there are taken.
  bool resumes() const { return render.resume || render.shard; }
};

}  // namespace poinsot::job
