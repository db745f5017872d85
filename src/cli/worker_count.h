// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/render_options.h"
#include "job/render_request.h"

namespace poinsot::cli {

/// Returns the number of workers: the value of -j, or else one per CPU. If memory holds fewer than that, the
/// number is reduced with a note on stderr.
/// @param most  number of workers that have something to do
/// @param each  request of one worker
/// @throws core::Error(kLimit) if a worker needs more memory than allowed; core::Error(kGraphics) if memory does
/// not hold one worker, or not as many as -j
int workerCount(const RenderOptions& options, int most, const job::RenderRequest& each);

}  // namespace poinsot::cli
