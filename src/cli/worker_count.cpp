// SPDX-License-Identifier: Apache-2.0
#include "cli/worker_count.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/memory.h"
#include "app/render_job.h"
#include "cli/console.h"
#include "core/error.h"

namespace poinsot::cli {
int workerCount(const RenderOptions& options, int most, double each_bytes, image::PixelSize size,
                const scene::Limits& limits) {
  const std::string worker = app::pictureText(size);
  app::expectWithinMemory(each_bytes, worker, limits);
  const int asked = options.jobs > 0 ? options.jobs : app::availableCpus();
  const int needed = std::min(asked, most);
  const app::FreeMemory free = app::freeMemory();
  const int fit = app::workersThatFit(needed, each_bytes, free);
  if (fit == needed) return asked;
  const std::string why =
      fmt::format("{} takes about {} of memory, and {} are free", worker, app::memoryText(each_bytes),
                  app::memoryText(std::min(free.machine_bytes, free.process_bytes)));
  if (fit == 0) throw core::Error(core::ErrorKind::kGraphics, why);
  if (options.jobs > 0)
    throw core::Error(core::ErrorKind::kGraphics, fmt::format("-j {}: {}; -j {} would do", asked, why, fit));
  if (!options.quiet) writeErr(fmt::format("poinsot: {} in place of {} workers: {}\n", fit, needed, why));
  return fit;
}

}  // namespace poinsot::cli
