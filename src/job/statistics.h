// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/step_times.h"

namespace poinsot::job {

/// What a worker, or all of them together, spent.
struct Statistics {
  std::int64_t frames = 0;
  std::int64_t workers = 0;
  double first_s = 0;           ///< CPU: making each worker's first frame, in which the driver compiles shaders
  core::StepTimes steps;        ///< of all else; those that make pictures, of all other frames
  double cpu_s = 0;             ///< CPU of the processes in all, start-up included
  double peakMemory_bytes = 0;  ///< summed over processes, each at its own peak

  Statistics& operator+=(const Statistics& other);
};

/// Of this process so far.
double processPeakMemory_bytes();

/// A table of CPU milliseconds per frame by step, frames per second and memory; lines end with a newline.
std::string statisticsText(const Statistics& sum, double wall_s);

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
