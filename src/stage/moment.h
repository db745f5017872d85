// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::stage {

/// An instant of a film, or a still of it. A label that is on its way to another place, or behind a body, is faint
/// for a while in a film, as a caption is that comes or goes; in a still it is there or not.
struct Moment {
  double filmTime_s = 0;
  bool still = false;

  Moment(double t_s, bool isStill = false) : filmTime_s(t_s), still(isStill) {}  // a time is one of the film
};

}  // namespace poinsot::stage
