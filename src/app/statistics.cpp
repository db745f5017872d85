// SPDX-License-Identifier: Apache-2.0
#include "app/statistics.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <iterator>

namespace poinsot::app {
Statistics& Statistics::operator+=(const Statistics& other) {
  frames += other.frames;
  making.compose_s += other.making.compose_s;
  making.render_s += other.making.render_s;
  making.read_s += other.making.read_s;
  making.text_s += other.making.text_s;
  convert_s += other.convert_s;
  encode_s += other.encode_s;
  cpu_s += other.cpu_s;
  peakMemory_bytes += other.peakMemory_bytes;
  return *this;
}

double processCpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double processPeakMemory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);  // Linux counts kilobytes
}

std::string statisticsText(const Statistics& sum, int workers, double wall_s) {
  const auto frames = static_cast<double>(std::max<std::int64_t>(sum.frames, 1));
  const FrameTimes& making = sum.making;
  const double steps_s =
      making.compose_s + making.render_s + making.read_s + making.text_s + sum.convert_s + sum.encode_s;
  std::string text = fmt::format("{} frames in {:.2f} s with {} worker{}: {:.1f} frames/s\n", sum.frames, wall_s,
                                 workers, workers == 1 ? "" : "s", static_cast<double>(sum.frames) / wall_s);
  const auto line = [&](const char* step, double seconds) {
    fmt::format_to(std::back_inserter(text), "  {:<20}{:>9.2f} ms CPU per frame\n", step, 1e3 * seconds / frames);
  };
  line("simulate + compose", making.compose_s);
  line("render", making.render_s);
  line("text", making.text_s);
  line("read", making.read_s);
  line("convert", sum.convert_s);
  line("encode + write", sum.encode_s);
  line("start and other", std::max(0.0, sum.cpu_s - steps_s));
  line("in all", sum.cpu_s);
  return text + fmt::format("  peak memory         {:>9.0f} MiB in {} worker{}\n",
                            sum.peakMemory_bytes / (1 << 20), workers, workers == 1 ? "" : "s");
}

}  // namespace poinsot::app
