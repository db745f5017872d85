// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/render_options.h"
#include "job/render_request.h"

namespace poinsot::cli {

/// Returns the number of workers: the value of -j, or one per CPU. Without -j, reduces the number if memory does
/// not suffice, with a note on stderr.
/// @param most  number of workers that can be used at the same time
/// @param each  request of one worker
/// @throws core::Error(kLimit) if a worker needs more memory than allowed; core::Error(kGraphics) if memory does
/// not suffice for one worker, or for the value of -j
int workerCount(const RenderOptions& options, int most, const job::RenderRequest& each);

}  // namespace poinsot::cli
