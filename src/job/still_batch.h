// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/error.h"
#include "job/render_job.h"

namespace poinsot::job {

/// Callback after each picture, with its index in the batch, and with the error if the picture failed.
using StillListener = std::function<void(std::size_t index, const std::optional<core::Error>& failure)>;

struct MadeStill {
  std::optional<core::Error> failure;
  RenderSummary summary;  ///< valid only if `failure` is empty
};

/// Renders pictures of several scenes with `jobs` workers at a time. If a picture fails, continues with the
/// others. The order in which pictures finish does not affect them.
/// @pre every request is of one frame.
/// @returns one result per request, in the same order
/// @throws Interrupted
std::vector<MadeStill> makeStills(std::vector<RenderRequest> requests, int jobs, const StillListener& listener);

}  // namespace poinsot::job
