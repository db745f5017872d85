// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/abi.h"

/// Notes and read-outs: text at a fixed position in the picture, not attached to any object.
namespace poinsot::scene {

enum class Spot { kTopLeft, kTop, kTopRight, kLeft, kCentre, kRight, kBottomLeft, kBottom, kBottomRight };

/// Matrix of a body that a note can show. The order is the order of the key's words.
enum class BodyMatrix {
  kInertia,              ///< about the fixed point, along B (eq 3, 7)
  kInertiaCentre,        ///< about the centre of mass, along B (eq 7)
  kInertiaDisplacement,  ///< M(a² 1 - a a), where a points from the centre of mass to the pivot (eq 14)
  kInertiaPrincipal,     ///< along the principal axes (eq 17)
  kUPrincipal,           ///< matrix U of the principal axes (eq 15)
  kInertiaOwn,           ///< along the scene's own axes (eq 16)
  kUOwn,                 ///< matrix U of the scene's own axes (eq 15)
};

/// Lines of text that do not change during the film, such as a remark or an equation.
struct Note {
  std::vector<std::string> lines;  ///< lines in the TeX subset of the text library
  Spot at = Spot::kBottom;
  double size = 1;                   ///< factor on the size of the letters
  std::optional<BodyMatrix> matrix;  ///< matrix that the note shows; `lines` is then its name, or empty
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
