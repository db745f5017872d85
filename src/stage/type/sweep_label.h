// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/sweep.h"

namespace poinsot::stage {

/// Labels of the cells of one range, in TeX, such as "$\omega_2 = 4.2\,\mathrm{rad/s}$".
struct SweepLabels {
  std::string name;                 ///< name of the range, such as "$\omega_2$"
  std::vector<std::string> values;  ///< one value for each cell, such as "$4.2\,\mathrm{rad/s}$"
  std::vector<std::string> whole;
};

/// Returns the usual symbol of a range's key. A key without a symbol gets the words of its path, such as "plane
/// opacity".
/// @param scene  scene of a cell
std::string sweptName(const scene::SweepAxis& axis, const scene::Scene& scene);

/// Returns the times of the motion at the film times in a range of scene::kInstantKey, in s. A film time after the
/// end of the film counts as the end.
std::vector<double> instants_s(const scene::SweepAxis& axis, const scene::Scene& scene);

/// Returns the labels of each range. Instants are labelled with the time of the motion, which a read-out of t
/// shows.
/// @param scene  scene of the first cell, with its final speed
/// @param names  names given by the user, for the first range, the second and so on; a range without one is named
/// by sweptName()
/// @throws core::Error(kUsage) if a name is not TeX.
std::vector<SweepLabels> sweepLabels(const std::vector<scene::SweepAxis>& axes,
                                     const std::vector<std::string>& names, const scene::Scene& scene);

}  // namespace poinsot::stage
