// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "core/abi.h"

namespace poinsot::stage {

/// Instant of a film, or of a still from that film. In a film, a label fades while it changes place or is behind a
/// body, and a caption fades in and out. In a still, labels and captions are either shown or absent.
struct Moment {
  double filmTime_s = 0;
  bool still = false;

  // Implicit, because every film time is a moment.
  Moment(double t_s, bool isStill = false) : filmTime_s(t_s), still(isStill) {}
};

/// Checks what every composer expects: a finite film time that is not negative, and a picture of at least one
/// pixel.
/// @throws std::logic_error otherwise.
void expectPicture(const Moment& moment, glm::ivec2 size_px);

/// Checks that a moment is within the film, because cameras, axes and labels are computed for its duration only.
/// @throws core::Error(kLimit) beyond the film's end.
void requireWithin(const Moment& moment, double duration_s);

}  // namespace poinsot::stage
