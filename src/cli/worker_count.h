// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/render_options.h"
#include "job/render_request.h"

namespace poinsot::cli {

/// How many workers may run: as many as -j says, else one per CPU or, which is said on stderr, as many as memory
/// holds.
/// @param most  that there is work for.
/// @param each  what one makes.
/// @throws core::Error(kLimit) if one may not have so much; (kGraphics) with these figures if not one fits, or not
/// as many as -j says.
int workerCount(const RenderOptions& options, int most, const job::RenderRequest& each);

}  // namespace poinsot::cli
