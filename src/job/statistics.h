// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/step_times.h"

namespace poinsot::job {

/// Time and memory spent by one worker, or by all workers together.
struct Statistics {
  std::int64_t frames = 0;
  std::int64_t workers = 0;
  double first_s = 0;           ///< CPU time of making each worker's first frame, shader compilation included
  core::StepTimes steps;        ///< CPU time by step, except for first_s
  double cpu_s = 0;             ///< CPU time of whole processes, start-up included
  double peakMemory_bytes = 0;  ///< sum of the processes' own peaks

  Statistics& operator+=(const Statistics& other);
};

double processPeakMemory_bytes();

/// Returns a table of CPU milliseconds per frame by step, frames per second and memory. Lines end with a newline.
std::string statisticsText(const Statistics& sum, double wall_s);

struct RenderSummary {
  Statistics spent;
  double wall_s = 0;
  std::int64_t reused = 0;       ///< frames that existed already
  bool replacedDamaged = false;  ///< the render replaced a damaged film of the same job
  std::string renderer;          ///< GL_RENDERER of a worker; empty if none drew
  std::string pixels;            ///< pixelDigest() of a still, if requested
  std::string driver;            ///< gl::OffscreenContext::driver(); empty if no worker opened a context
};

}  // namespace poinsot::job
