// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "core/abi.h"

namespace poinsot::stage {

/// An instant of a film, or a still of it. A label that is on its way to another place, or behind a body, is faint
/// for a while in a film, as a caption is that comes or goes; in a still it is there or not.
struct Moment {
  double filmTime_s = 0;
  bool still = false;

  Moment(double t_s, bool isStill = false) : filmTime_s(t_s), still(isStill) {}  // a time is one of the film
};

/// Checks what every composer expects: a film time that is finite and not negative, a picture of at least one
/// pixel.
/// @throws std::logic_error otherwise.
void expectPicture(const Moment& moment, glm::ivec2 size_px);

/// @throws core::Error(kLimit) beyond the film's end: cameras, axes and labels are worked out for the film.
void requireWithin(const Moment& moment, double duration_s);

}  // namespace poinsot::stage
