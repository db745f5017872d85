// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/sweep.h"

namespace poinsot::stage {

/// What is written at the cells of one range, in TeX: "$\omega_2 = 4.2\,\mathrm{rad/s}$".
struct SweepLabels {
  std::string name;                 ///< "$\omega_2$"
  std::vector<std::string> values;  ///< "$4.2\,\mathrm{rad/s}$", one for each
  std::vector<std::string> whole;   ///< both, with the equals sign
};

/// The symbol that a book has for the key, else the words of its path. @param scene  of a cell
std::string sweptName(const scene::SweepAxis& axis, const scene::Scene& scene);

/// Of each range. `names`: in place of the first ranges' own.
/// @throws core::Error(kUsage) for a name that is no TeX.
std::vector<SweepLabels> sweepLabels(const std::vector<scene::SweepAxis>& axes,
                                     const std::vector<std::string>& names, const scene::Scene& scene);

}  // namespace poinsot::stage
