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

struct ReadoutText {
  scene::Spot at = scene::Spot::kTop;
  std::string name;    ///< name and equals sign
  std::string value;   ///< value, such as "$3.20$"
  std::string widest;  ///< text of the widest value in the film
  std::string unit;    ///< unit and the space before it; empty for a bare number
  draw::Color color{0};
};

struct ReadoutFormat {
  WrittenUnit unit;
  int decimals = 0;

  std::string tex(double si, scene::DecimalSign sign) const;
};

/// Returns a format with enough decimals to distinguish a film's values, but at most four digits. A constant value
/// gets four digits.
/// @param asked  unit of the read-out; empty: a suitable unit is chosen
ReadoutFormat readoutFormat(scene::QuantityUnit unit, const QuantityRange& range, const std::string& asked = "");

class ReadoutBoard {
 public:
  /// @param motion  drawnMotion() of the scene
  /// @param least  one range for each read-out, whose values must also fit the number of digits; may be empty
  ReadoutBoard(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion, const Palette& colors,
               std::span<const QuantityRange> least = {});

  /// Returns the range of each read-out, joined with the range passed to the constructor.
  const std::vector<QuantityRange>& ranges() const { return ranges_; }

  std::vector<ReadoutText> at(double filmTime_s) const;

 private:
  std::optional<QuantityTrack> track_;
  std::vector<QuantityRange> ranges_;
  std::vector<ReadoutFormat> formats_;
  std::vector<ReadoutText> texts_;
  scene::DecimalSign sign_;
};

}  // namespace poinsot::stage
