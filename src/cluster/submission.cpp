// SPDX-License-Identifier: Apache-2.0
#include "cluster/submission.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"

namespace poinsot::cluster {
namespace {

constexpr double kMostTasks = 1000;

/// Returns a guess of the CPU seconds per frame: the time of the slower of two measured scenes. Measured with the
/// scenes football and poinsot_construction on one CPU of a rented machine: 0.04 s at 640x360, 0.09 to 0.15 s at
/// 1920x1080, 0.26 to 0.48 s at 3840x2160.
double guessedFrame_s(double megapixels) { return 0.03 + 0.055 * megapixels; }

/// Returns the memory in MiB that a task requests for each worker: a constant for the parent process plus 1.5
/// times the worker's memory, rounded up to a multiple of 256 MiB.
std::int64_t taskMemory(double worker_bytes) {
  constexpr double kParent_MiB = 64, kStep_MiB = 256;
  const double needed_MiB = kParent_MiB + 1.5 * worker_bytes / (1 << 20);
  return static_cast<std::int64_t>(kStep_MiB * std::ceil(needed_MiB / kStep_MiB));
}

}  // namespace

Division divisionOf(const DivisionRequest& request, const request::FrameRange& frames,
                    const std::vector<request::FrameRange>& segments, image::PixelSize size, double worker_bytes) {
  POINSOT_EXPECT(request.cpus > 0 && request.task_s > 0 && !segments.empty());
  const double megapixels = 1e-6 * size.width * size.height;
  Division division;
  division.cpus = request.cpus;
  division.memory = taskMemory(worker_bytes);
  division.frame_s = request.frame_s.value_or(guessedFrame_s(megapixels));
  const double taskWork_s = request.task_s * request.cpus;
  const double wanted = std::ceil(static_cast<double>(frames.count()) * division.frame_s / taskWork_s);
  const auto most = static_cast<int>(segments.size());
  division.shards = std::min(most, request.shards.value_or(static_cast<int>(std::clamp(wanted, 1.0, kMostTasks))));
  const std::int64_t most_frames =
      request::framesIn(request::segmentsOf(request::Shard{1, division.shards}, segments));
  division.task_s = static_cast<double>(most_frames) * division.frame_s / request.cpus;
  return division;
}

std::filesystem::path tasksFolderOf(const Submission& submission) {
  return submission.output.path.string() + ".tasks";
}

}  // namespace poinsot::cluster
