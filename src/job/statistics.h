// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/step_times.h"

namespace poinsot::job {

/// Time and memory used by one worker, or by all workers together.
struct Statistics {
  std::int64_t frames = 0;
  std::int64_t workers = 0;
  double first_s = 0;           ///< CPU time for the first frame of each worker, including shader compilation
  core::StepTimes steps;        ///< CPU time of each step, without first_s
  double cpu_s = 0;             ///< CPU time of the complete processes, including their start
  double peakMemory_bytes = 0;  ///< sum of the peak memory of each process

  Statistics& operator+=(const Statistics& other);
};

double processPeakMemory_bytes();

/// Returns a table with the CPU time per frame in ms for each step, the frame rate and the memory, with a final
/// newline.
std::string statisticsText(const Statistics& sum, double wall_s);

struct RenderSummary {
  Statistics spent;
  double wall_s = 0;
  std::int64_t reused = 0;       ///< frames that existed before the render
  bool replacedDamaged = false;  ///< the old film of the same job was damaged and has been replaced
  std::int64_t film_bytes = 0;   ///< size of the film, if RenderChoices::accepted is set
  bool written = true;           ///< false if RenderChoices::accepted does not contain the film's size
  std::string renderer;          ///< GL_RENDERER of a worker; empty if no worker drew
  std::string pixels;            ///< pixelDigest() of a still, if requested
  std::string driver;            ///< gl::OffscreenContext::driver(); empty if no worker opened a context
};

}  // namespace poinsot::job
