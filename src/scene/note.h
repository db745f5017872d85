// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/abi.h"

/// Notes and read-outs: text at a fixed place in the picture, not attached to any object.
namespace poinsot::scene {

enum class Spot { kTopLeft, kTop, kTopRight, kLeft, kCentre, kRight, kBottomLeft, kBottom, kBottomRight };

/// Static lines of text, such as a caption or an equation.
struct Note {
  std::vector<std::string> lines;  ///< in the TeX subset of the text library
  Spot at = Spot::kBottom;
  double size = 1;  ///< factor on the type size
};

/// Value of a quantity at the picture's instant, such as "t = 3.20 s". Read-outs at one place are stacked.
struct Readout {
  int quantity = 0;  ///< index into stateQuantities()
  Spot at = Spot::kTopRight;
  std::string label;  ///< in the TeX subset of the text library; empty: the quantity's symbol
  std::string unit;   ///< such as "rpm"; empty: chosen to suit the numbers
};

}  // namespace poinsot::scene
