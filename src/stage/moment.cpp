// SPDX-License-Identifier: Apache-2.0
#include "stage/moment.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/expect.h"

namespace poinsot::stage {

void expectPicture(const Moment& moment, glm::ivec2 size_px) {
  POINSOT_EXPECT(moment.filmTime_s >= 0 && std::isfinite(moment.filmTime_s));
  POINSOT_EXPECT(size_px.x >= 1 && size_px.y >= 1);
}

void requireWithin(const Moment& moment, double duration_s) {
  if (moment.filmTime_s > duration_s)
    throw core::limitError(
        fmt::format("film time {} s: the film lasts from 0 to {} s", moment.filmTime_s, duration_s));
}

}  // namespace poinsot::stage
