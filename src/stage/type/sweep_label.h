// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/sweep.h"

namespace poinsot::stage {

/// Labels of the cells of one range, in TeX: "$\omega_2 = 4.2\,\mathrm{rad/s}$".
struct SweepLabels {
  std::string name;                 ///< "$\omega_2$"
  std::vector<std::string> values;  ///< "$4.2\,\mathrm{rad/s}$", one for each
  std::vector<std::string> whole;
};

/// Returns the symbol that books use for the key, or else the words of its path. @param scene  scene of a cell
std::string sweptName(const scene::SweepAxis& axis, const scene::Scene& scene);

/// Returns the labels of each range.
/// @param names  replace the names of the first ranges
/// @throws core::Error(kUsage) if a name is not TeX.
std::vector<SweepLabels> sweepLabels(const std::vector<scene::SweepAxis>& axes,
                                     const std::vector<std::string>& names, const scene::Scene& scene);

}  // namespace poinsot::stage
