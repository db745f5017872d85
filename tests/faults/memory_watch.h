// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/program_run.h"

namespace poinsot::faults {

/// Memory (VmRSS) of the processes of a render, sampled every 20 ms.
class MemoryWatch {
 public:
  /// Runs a render to its end and expects success.
  /// @param arguments  with --progress json and -j 1
  MemoryWatch(const ScratchFolder& folder, const std::vector<std::string>& arguments);

  std::int64_t frames() const { return samples_.back().done; }
  /// Returns the worker's peak while `from` to `to` frames were done.
  double workerPeak_MiB(std::int64_t from, std::int64_t to) const;
  /// Returns the median of the worker's samples in that time. Unlike the peak, the median does not depend on the
  /// number of frames that an encoder's threads buffered at one moment.
  double workerMedian_MiB(std::int64_t from, std::int64_t to) const;
  double parentPeak_MiB() const;

 private:
  struct Sample {
    std::int64_t done = 0;
    double parent_MiB = 0, worker_MiB = 0;
  };
  static Sample sampleOf(const ProgramRun& run);
  std::vector<double> worker_MiB(std::int64_t from, std::int64_t to) const;

  std::vector<Sample> samples_;
};

}  // namespace poinsot::faults
