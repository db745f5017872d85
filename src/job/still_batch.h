// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/error.h"
#include "job/render_job.h"

namespace poinsot::job {

/// Called after each picture with its place in the batch and what went wrong, if something did.
using StillListener = std::function<void(std::size_t index, const std::optional<core::Error>& failure)>;

/// Result of making one of the pictures.
struct MadeStill {
  std::optional<core::Error> failure;
  RenderSummary summary;  ///< where it did not fail
};

/// Makes pictures of several scenes, `jobs` workers at a time. One that fails stops no other. The order in which
/// they are done is open, the pictures are not.
/// @pre every request is of one frame.
/// @returns the result of each request.
/// @throws Interrupted
std::vector<MadeStill> makeStills(std::vector<RenderRequest> requests, int jobs, const StillListener& listener);

}  // namespace poinsot::job
