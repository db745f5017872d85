// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

/// Limits and presets of the output, shared by the scene file and the command line.
namespace poinsot::scene {

/// What bounds a scene and all that is made of it. The user raises a limit, a scene never does.
enum class Limit {
  kSceneBytes,
  kStringBytes,
  kNesting,
  kValues,
  kElements,
  kFileBytes,
  kFilesBytes,
  kTriangles,
  kCharacters,
  kSide,
  kFrames,
  kFps,
  kDuration,
  kSteps,
  kMemory,
  kOutput,
  kSeconds,
};

inline constexpr std::size_t kLimitCount = 17;

enum class LimitUnit { kCount, kBytes, kSeconds, kPixels };

/// A row of the one table of limits, from which the command line and the reference are made.
struct LimitRow {
  std::string_view name;
  LimitUnit unit = LimitUnit::kCount;
  std::int64_t usual = 0;    ///< 0: none
  std::int64_t highest = 0;  ///< to which a user may raise it
  std::string_view help;     ///< what it bounds
};

/// In the order of Limit.
std::span<const LimitRow> limitTable();
const LimitRow& rowOf(Limit limit);

/// What holds unless the user says otherwise.
double usual(Limit limit);

/// A value in its unit: "4 MiB", "8192 pixels".
std::string limitText(Limit limit, std::int64_t value);

/// How a user raises a limit, for the end of a message: "--limit side=N raises that".
std::string howToRaise(Limit limit);

/// The values in force.
class Limits {
 public:
  /// The usual ones.
  Limits();

  std::int64_t operator[](Limit limit) const { return values_.at(static_cast<std::size_t>(limit)); }
  std::size_t bytes(Limit limit) const { return static_cast<std::size_t>((*this)[limit]); }

  /// @throws core::Error(kUsage) saying what it may be: a positive number, at most LimitRow::highest.
  void set(Limit limit, std::int64_t value);
  /// As a user writes it: "16384", "64 GiB". @throws as set().
  void set(Limit limit, std::string_view value);
  /// "side=16384". @throws core::Error(kUsage) also for a name that there is not.
  void setByWord(std::string_view word);

  bool operator==(const Limits&) const = default;

 private:
  std::array<std::int64_t, kLimitCount> values_{};
};

/// The limit of that name. @throws core::Error(kUsage), with the nearest name that there is.
Limit limitNamed(std::string_view name);

/// What the user allows a scene: how much, and files of which folders besides its own.
struct Allowance {
  Limits limits;
  std::vector<std::filesystem::path> assetRoots;  ///< searched in this order, after the scene's folder
};

constexpr int kLeastSide = 16;
constexpr double kLeastMoment = 1e-60;  ///< kg·m², given or of a shape; a mass has the same limits in kg
constexpr double kMostMoment = 1e60;
constexpr double kLeastSpin = 1e-40;  ///< rad/s, of each component that is not zero
constexpr double kMostSpin = 1e40;
constexpr double kMostInstant_s = 1e20;       ///< either way; times the spin it is an angle
constexpr double kMostTorque = 1e140;         ///< N·m, a moment times the square of a spin
constexpr double kMostRatioOfMoments = 1e20;  ///< largest to smallest; physics::FreeMotion solves no more

constexpr std::size_t kMostLines = 40;  ///< of one note: what a picture can hold

/// What one word of `quality` sets; an explicit size or crf wins.
struct QualityPreset {
  std::string_view name;
  int width, height, crf;
};

std::span<const QualityPreset> qualityPresets();

/// Words of the keys of the same names.
std::span<const std::string_view> codecWords();
std::span<const std::string_view> chromaWords();
std::span<const std::string_view> effortWords();

/// The preset of that name, or null.
const QualityPreset* qualityPreset(std::string_view name);

}  // namespace poinsot::scene
