// SPDX-License-Identifier: Apache-2.0
#include "cli/worker_count.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/console.h"
#include "core/error.h"
#include "job/render_job.h"
#include "request/memory.h"

namespace poinsot::cli {

int workerCount(const RenderOptions& options, int most, const job::RenderRequest& each) {
  job::expectWithinMemory(each);
  const int asked = options.jobs > 0 ? options.jobs : job::availableCpus();
  const int needed = std::min(asked, most);
  const request::FreeMemory free = request::freeMemory();
  const int fit = request::workersThatFit(needed, each.worker_bytes, free);
  if (fit == needed) return asked;
  const std::string why =
      fmt::format("{} takes about {} of memory, and {} are free", request::pictureText(each.scene.size()),
                  request::memoryText(each.worker_bytes),
                  request::memoryText(std::min(free.machine_bytes, free.process_bytes)));
  if (fit == 0) throw core::graphicsError(why);
  if (options.jobs > 0) throw core::graphicsError(fmt::format("-j {}: {}; use -j {}", asked, why, fit));
  if (!options.quiet) writeErr(fmt::format("poinsot: {} instead of {} workers: {}\n", fit, needed, why));
  return fit;
}

}  // namespace poinsot::cli
