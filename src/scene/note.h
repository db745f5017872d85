// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/abi.h"

/// What is written into a picture and follows no thing: notes and read-outs.
namespace poinsot::scene {

/// Where in the picture, three rows of three.
enum class Spot { kTopLeft, kTop, kTopRight, kLeft, kCentre, kRight, kBottomLeft, kBottom, kBottomRight };

/// Lines that stand still: a caption, an equation.
struct Note {
  std::vector<std::string> lines;  ///< the TeX subset of text/
  Spot at = Spot::kBottom;
  double size = 1;  ///< factor on its type
};

/// A quantity's value at the picture's instant: "t = 3.20 s". Several at one place stand under one another.
struct Readout {
  int quantity = 0;  ///< index into stateQuantities()
  Spot at = Spot::kTopRight;
  std::string label;  ///< the TeX subset of text/; empty: the quantity's symbol
  std::string unit;   ///< "rpm"; empty: one that suits the numbers
};

}  // namespace poinsot::scene
