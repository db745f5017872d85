// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "core/abi.h"

namespace poinsot::stage {

/// Instant of a film, drawn as a frame of the film or as a still. In a frame, a label fades while it changes its
/// position or is behind a body, and captions fade in and out. In a still, labels and captions are either shown or
/// absent.
struct Moment {
  double filmTime_s = 0;
  bool still = false;

  // Implicit, because every film time is a moment.
  Moment(double t_s, bool isStill = false) : filmTime_s(t_s), still(isStill) {}
};

/// Checks the arguments of a composer: the film time must be finite and not negative, and the picture must have at
/// least one pixel.
/// @throws std::logic_error if an argument is invalid.
void expectPicture(const Moment& moment, glm::ivec2 size_px);

/// Checks that a moment is within the film. Cameras, axes and labels are computed only for the film's duration.
/// @throws core::Error(kLimit) beyond the film's end.
void requireWithin(const Moment& moment, double duration_s);

}  // namespace poinsot::stage
