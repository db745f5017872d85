// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Ranges in overrides (the words after -D): "motion.omega_body=[0.01..0.05:3, 4, 0]" stands for three scenes.
namespace poinsot::scene {

/// Largest number of scenes drawn side by side. Each has its own motion, and each panel must stay recognisable.
inline constexpr int kMostCells = 100;

struct SweepValue {
  std::string text;    ///< as written in a scene: "10 rpm"
  std::string number;  ///< with as many decimals as its neighbours: "10.0"
};

/// Swept key and its values, one for each scene.
struct SweepAxis {
  std::string key;             ///< "motion.omega_body"
  std::optional<int> element;  ///< index of the swept element of a vector or list, from 0
  std::string unit;            ///< unit of the numbers as typed, else the SI unit; empty for a bare number
  std::vector<SweepValue> values;
  std::string before, after;  ///< text of the override before and after the range

  std::string override(std::size_t value) const;
};

/// Returns whether an override contains a range, valid or not.
bool hasRange(std::string_view override);

/// Parses the range in an override; nullopt if there is none. Only numbers have ranges, because a title may have
/// dots.
///
///     a..b:n      n values from a to b, both included, evenly; with a unit: 10..50 rpm:5
///     a..b:n:log  in equal ratios
///     a|b|c       these values
///
/// An override has at most one range; in a list, one element may be a range.
/// @throws core::Error(kUsage) for a malformed range, naming the valid forms.
std::optional<SweepAxis> sweepAxis(const std::string& override);

}  // namespace poinsot::scene
