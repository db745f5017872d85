// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/abi.h"

namespace poinsot::scene {

/// Names of the things that have a label, in the order of labelDefaults().
enum class LabelName {
  kL,
  kOmega,
  kTorque,
  kE1,
  kE2,
  kE3,
  kX,
  kY,
  kZ,
  kAxis,
  kTheta,
  kHeight,
  kPlane,
  kOmegaP,
  kSpin,
  kOmega1,
  kOmega2,
  kOmega3,
  kR,
  kV,
  kWeight,
  kOrigin,
  kReferencePoint,
  kOrbitalL,
  kTotalL,
  kTorqueAboutOrigin,
  kSpaceCone,
  kBodyCone,
  kI,
  kJ,
  kLAlongOmega,
  kLAlongAxis,
  kCount
};

struct LabelDefault {
  std::string_view key;       ///< name of the key in the table "label"
  std::string_view fallback;  ///< default of the text, as TOML
  std::string_view example;
  std::string_view help;
};

constexpr std::size_t kLabelCount = static_cast<std::size_t>(LabelName::kCount);

const std::array<LabelDefault, kLabelCount>& labelDefaults();

/// Texts of all labels, in the TeX subset of the text library. An empty text hides the label.
class LabelTexts {
 public:
  const std::string& operator[](LabelName name) const { return texts_[static_cast<std::size_t>(name)]; }
  std::string& operator[](LabelName name) { return texts_[static_cast<std::size_t>(name)]; }

 private:
  std::array<std::string, kLabelCount> texts_;
};

}  // namespace poinsot::scene
