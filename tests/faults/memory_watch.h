// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/program_run.h"

namespace poinsot::faults {

/// What the processes of a render held of memory (VmRSS) while it ran, looked at every 20 ms.
class MemoryWatch {
 public:
  /// Runs it to its end, which must be a good one. @param arguments  with --progress json and -j 1.
  MemoryWatch(const ScratchFolder& folder, const std::vector<std::string>& arguments);

  std::int64_t frames() const { return samples_.back().done; }
  /// Most of the worker while `from` to `to` frames were done.
  double workerPeak_MiB(std::int64_t from, std::int64_t to) const;
  /// Half of the looks at the worker meanwhile found at most this: unlike the peak, it does not depend on how many
  /// frames an encoder's threads once had in hand.
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
