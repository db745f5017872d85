// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Ranges among the words after -D: "motion.omega_body=[0.01..0.05:3, 4, 0]" stands for three scenes.
namespace poinsot::scene {

/// Scenes that are drawn side by side at most: each has its motion, and a panel that is still a picture.
inline constexpr int kMostCells = 100;

/// One of the values that a range stands for.
struct SweepValue {
  std::string text;    ///< as a scene has it: "10 rpm"
  std::string number;  ///< of the decimals that its neighbours have: "10.0"
};

/// A key and the values that it takes, one for each scene.
struct SweepAxis {
  std::string key;             ///< "motion.omega_body"
  std::optional<int> element;  ///< of a vector or a list, from 0
  std::string unit;            ///< of the numbers, as typed, else the SI unit; empty for a bare number
  std::vector<SweepValue> values;
  std::string before, after;  ///< the values in the word after -D

  /// The word after -D of one scene.
  std::string override(std::size_t value) const;
};

/// Whether a word after -D has a range, right or wrong.
bool hasRange(std::string_view override);

/// The range in a word after -D; none where there is none. Of numbers only: a title may have dots.
///
///     a..b:n      n values from a to b, both included, evenly; with a unit: 10..50 rpm:5
///     a..b:n:log  in equal ratios
///     a|b|c       these
///
/// The word may have one; in a list it is one of the elements.
/// @throws core::Error(kUsage) for one that cannot be understood, saying what it may be.
std::optional<SweepAxis> sweepAxis(const std::string& override);

}  // namespace poinsot::scene
