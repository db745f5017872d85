// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/motion.h"
#include "scene/scene.h"
#include "stage/palette.h"
#include "stage/quantity_track.h"
#include "stage/type/written_number.h"

namespace poinsot::stage {

/// A read-out in TeX, at one instant.
struct ReadoutText {
  scene::Spot at = scene::Spot::kTop;
  std::string name;    ///< with the equals sign
  std::string value;   ///< "$3.20$"
  std::string widest;  ///< what no value of the film is wider than
  std::string unit;    ///< with the space before it; empty for a bare number
  draw::Color color{0};
};

/// How a quantity's values are written all film long.
struct ReadoutFormat {
  WrittenUnit unit;
  int decimals = 0;

  std::string tex(double si, scene::DecimalSign sign) const;
};

/// With as many decimals as tell a film's values apart, but for four digits at most; four of a value that stands
/// still. In the unit `asked`, or where that is empty in one that suits.
ReadoutFormat readoutFormat(scene::QuantityUnit unit, const QuantityRange& range, const std::string& asked = "");

/// A scene's read-outs over its film.
class ReadoutBoard {
 public:
  /// `motion`: drawnMotion() of the scene. @param least  for what other ranges the digits are chosen besides, one
  /// for each; or none
  ReadoutBoard(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion, const Palette& colors,
               std::span<const QuantityRange> least = {});

  /// Of each, with those that it was made for.
  const std::vector<QuantityRange>& ranges() const { return ranges_; }

  /// In the order of the scene. A pure function.
  std::vector<ReadoutText> at(double filmTime_s) const;

 private:
  std::optional<QuantityTrack> track_;  // none without read-outs
  std::vector<QuantityRange> ranges_;
  std::vector<ReadoutFormat> formats_;
  std::vector<ReadoutText> texts_;  // all but the values
  scene::DecimalSign sign_;
};

}  // namespace poinsot::stage
