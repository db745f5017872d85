// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "job/render_request.h"
#include "scene/scene.h"

namespace poinsot::cli {

/// Prints what the render would make and, of a shard or with --resume, how much of it is there already.
/// @returns an exit code. @throws core::Error(kPhysics) if the motion lacks something.
int describe(const job::RenderRequest& request);

}  // namespace poinsot::cli
