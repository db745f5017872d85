// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "app/statistics.h"

namespace poinsot::app {

/// What a render came to.
struct RenderSummary {
  Statistics spent;
  double wall_s = 0;
  std::int64_t reused = 0;  ///< frames that were there already
};

}  // namespace poinsot::app
