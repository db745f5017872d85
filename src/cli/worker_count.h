// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/render_options.h"

namespace poinsot::cli {

/// How many workers may run: as many as -j says, else one per CPU or, which is said on stderr, as many as memory
/// holds.
/// @param most  that there is work for.
/// @param each_bytes  what one needs (request/memory.h), to make a picture of `size`.
/// @throws core::Error(kLimit) if one may not have so much; (kGraphics) with these figures if not one fits, or not
/// as many as -j says.
int workerCount(const RenderOptions& options, int most, double each_bytes, image::PixelSize size,
                const scene::Limits& limits);

}  // namespace poinsot::cli
