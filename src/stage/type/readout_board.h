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
  std::string name;    ///< name with the equals sign
  std::string value;   ///< for example "$3.20$"
  std::string widest;  ///< widest text: no value of the film is wider
  std::string unit;    ///< unit with the space before it; empty for a bare number
  draw::Color color{0};
};

struct ReadoutFormat {
  WrittenUnit unit;
  int decimals = 0;

  std::string tex(double si, scene::DecimalSign sign) const;
};

/// Returns a format with enough decimals to distinguish a film's values, but at most four digits; four digits for
/// a constant value.
/// @param asked  unit to write; empty: a suitable one
ReadoutFormat readoutFormat(scene::QuantityUnit unit, const QuantityRange& range, const std::string& asked = "");

class ReadoutBoard {
 public:
  /// @param motion  drawnMotion() of the scene
  /// @param least  ranges that the number of digits must also suit, one for each read-out; may be empty
  ReadoutBoard(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion, const Palette& colors,
               std::span<const QuantityRange> least = {});

  /// Returns the range of each read-out, joined with that passed to the constructor.
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
