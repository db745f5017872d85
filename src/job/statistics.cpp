// SPDX-License-Identifier: Apache-2.0
#include "job/statistics.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <iterator>

namespace poinsot::job {
namespace {

const char* plural(std::int64_t count) { return count == 1 ? "" : "s"; }

double otherCpu_s(const Statistics& sum) { return std::max(0.0, sum.cpu_s - sum.first_s - sum.steps.sum_s()); }

}  // namespace

Statistics& Statistics::operator+=(const Statistics& other) {
  frames += other.frames;
  workers += other.workers;
  first_s += other.first_s;
  steps += other.steps;
  cpu_s += other.cpu_s;
  peakMemory_bytes += other.peakMemory_bytes;
  return *this;
}

double processPeakMemory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);  // ru_maxrss is in kilobytes on Linux
}

std::string statisticsText(const Statistics& sum, double wall_s) {
  const auto perFrame = [](double seconds, std::int64_t frames) {
    return 1e3 * seconds / static_cast<double>(std::max<std::int64_t>(frames, 1));
  };
  std::string text =
      fmt::format("{} frame{} in {:.2f} s with {} worker{}: {:.1f} frames/s\n", sum.frames, plural(sum.frames),
                  wall_s, sum.workers, plural(sum.workers), static_cast<double>(sum.frames) / wall_s);
  const auto line = [&](const char* step, double milliseconds, const char* unit = "ms CPU per frame") {
    fmt::format_to(std::back_inserter(text), "  {:<20}{:>9.2f} {}\n", step, milliseconds, unit);
  };
  for (std::size_t i = 0; i < core::kSteps; ++i) {
    const auto step = static_cast<core::Step>(i);
    // Drawing the first frame of each worker is listed on a line of its own, so these frames do not count here.
    const auto frames = step <= core::Step::kText ? sum.frames - sum.workers : sum.frames;
    line(core::nameOf(step), perFrame(sum.steps[step], frames));
  }
  line("first frame", perFrame(sum.first_s, sum.workers), "ms CPU per worker, shaders compiled");
  line("start and other", perFrame(otherCpu_s(sum), sum.workers), "ms CPU per worker");
  line("in all", perFrame(sum.cpu_s, sum.frames));
  line("peak memory", sum.peakMemory_bytes / (1 << 20), "MiB, workers together");
  return text;
}

}  // namespace poinsot::job
