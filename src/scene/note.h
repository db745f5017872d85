// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/abi.h"

/// Notes and read-outs: text at a fixed position in the picture, not attached to any object.
namespace poinsot::scene {

enum class Spot { kTopLeft, kTop, kTopRight, kLeft, kCentre, kRight, kBottomLeft, kBottom, kBottomRight };

/// Lines of text that do not change during the film, such as a remark or an equation.
struct Note {
  std::vector<std::string> lines;  ///< lines in the TeX subset of the text library
  Spot at = Spot::kBottom;
  double size = 1;  ///< factor on the size of the letters
};

/// Value of a quantity at the picture's instant, such as "t = 3.20 s". Read-outs with the same position are
/// stacked.
struct Readout {
  int quantity = 0;  ///< index of the quantity in stateQuantities()
  Spot at = Spot::kTopRight;
  std::string label;  ///< text in the TeX subset of the text library; empty for the quantity's symbol
  std::string unit;   ///< unit such as "rpm"; empty for a unit that suits the numbers
};

}  // namespace poinsot::scene
