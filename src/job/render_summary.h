// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "job/statistics.h"

namespace poinsot::job {

/// What a render came to.
struct RenderSummary {
  Statistics spent;
  double wall_s = 0;
  std::int64_t reused = 0;       ///< frames that were there already
  bool replacedDamaged = false;  ///< whether a film of this job was there, of which bytes had changed
  std::string renderer;          ///< GL_RENDERER of a worker; empty where none drew
  std::string pixels;            ///< pixelDigest() of a still, where the request asks for it
  std::string driver;            ///< gl::OffscreenContext::driver(); empty if no worker opened a context
};

}  // namespace poinsot::job
