// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Ranges in overrides "-D key=value": "motion.omega_body=[0.01..0.05:3, 4, 0]" stands for three scenes.
namespace poinsot::scene {

/// Largest number of scenes in one picture. Each needs a motion of its own, and each panel must be recognisable.
inline constexpr int kMostCells = 100;

/// Key whose range makes a sheet of one scene at several instants: each cell shows its own film time.
inline constexpr std::string_view kInstantKey = "time.still";

struct SweepValue {
  std::string text;    ///< value as written in a scene, such as "10 rpm"
  std::string number;  ///< number with as many decimals as its neighbours, such as "10.0"; or a word
};

/// Key with a range, and the values of the range, one for each scene.
struct SweepAxis {
  std::string key;             ///< path of the key, such as "motion.omega_body"
  std::optional<int> element;  ///< index of the element with the range in a vector or list, from 0
  std::string unit;            ///< unit as typed, or the SI unit of the key; empty for a plain number
  std::vector<SweepValue> values;
  bool isWords = false;       ///< the values are words of the key, or true and false
  std::string before, after;  ///< text of the override before and after the range

  std::string override(std::size_t value) const;
  bool variesInstant() const { return key == kInstantKey; }
};

/// Returns whether an override contains a range, valid or not.
bool hasRange(std::string_view override);

/// Parses the range in an override. Returns nullopt if the override has no range. A range has one of these forms:
///
///     a..b:n      n equally spaced values from a to b, both included; with a unit, such as 10..50 rpm:5
///     a..b:n:log  n values from a to b in equal ratios
///     a|b|c       the values a, b and c: numbers, words of the key such as smallest|largest, or true|false
///
/// Keys of text have no ranges, because a title may contain dots. An override has at most one range. In a
/// list, one element may be a range.
/// @param most  largest n
/// @throws core::Error(kUsage) for a malformed range, naming the valid forms.
std::optional<SweepAxis> sweepAxis(const std::string& override, int most = kMostCells);

}  // namespace poinsot::scene
