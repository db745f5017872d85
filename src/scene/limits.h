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

/// Limit on a scene or on its output. Only the user can raise a limit; a scene cannot.
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

/// Row of the table of limits, from which the options of the command line and the reference are made.
struct LimitRow {
  std::string_view name;
  LimitUnit unit = LimitUnit::kCount;
  std::int64_t usual = 0;    ///< default; 0: no limit
  std::int64_t highest = 0;  ///< largest value that a user may set
  std::string_view help;
};

/// Returns the rows of all limits, in the order of Limit.
std::span<const LimitRow> limitTable();
const LimitRow& rowOf(Limit limit);

/// Returns the default of a limit; 0: no limit.
double usual(Limit limit);

/// Formats a value in the limit's unit, such as "4 MiB" or "8192 pixels".
std::string limitText(Limit limit, std::int64_t value);

/// Returns advice for the end of a message: "--limit side=N raises that".
std::string howToRaise(Limit limit);

class Limits {
 public:
  Limits();

  std::int64_t operator[](Limit limit) const { return values_.at(static_cast<std::size_t>(limit)); }
  std::size_t bytes(Limit limit) const { return static_cast<std::size_t>((*this)[limit]); }

  /// @throws core::Error(kUsage) unless `value` is from 1 to LimitRow::highest.
  void set(Limit limit, std::int64_t value);
  /// Parses and sets a value such as "16384" or, for bytes, "64 GiB".
  /// @throws core::Error(kUsage) for malformed text, and as above.
  void set(Limit limit, std::string_view value);
  /// Parses and sets a limit such as "side=16384".
  /// @throws core::Error(kUsage) for an unknown name, and as above.
  void setByWord(std::string_view word);

  bool operator==(const Limits&) const = default;

 private:
  std::array<std::int64_t, kLimitCount> values_{};
};

/// Finds a limit by name.
/// @throws core::Error(kUsage) for an unknown name, suggesting the nearest known one.
Limit limitNamed(std::string_view name);

/// Permissions that the user grants a scene: its limits, and folders besides its own that it may read from.
struct Allowance {
  Limits limits;
  std::vector<std::filesystem::path> assetRoots;  ///< searched in this order, after the scene's folder
};

constexpr int kLeastSide = 16;
constexpr double kLeastMoment = 1e-60;  ///< kg·m², given or of a shape; masses have the same limits in kg
constexpr double kMostMoment = 1e60;
constexpr double kLeastSpin = 1e-40;  ///< rad/s, for each nonzero component
constexpr double kMostSpin = 1e40;
constexpr double kMostInstant_s = 1e20;       ///< absolute value; multiplied by a spin, a time gives an angle
constexpr double kMostTorque = 1e140;         ///< N·m, a moment times the square of a spin
constexpr double kMostRatioOfMoments = 1e20;  ///< largest over smallest moment; the limit of physics::FreeMotion

constexpr std::size_t kMostLines = 40;  ///< lines of one note; a picture holds no more

/// Values set by one word of `output.quality`. An explicit size or crf overrides them.
struct QualityPreset {
  std::string_view name;
  int width, height, crf;
};

std::span<const QualityPreset> qualityPresets();

/// Words that the keys output.codec, output.chroma and output.effort accept.
std::span<const std::string_view> codecWords();
std::span<const std::string_view> chromaWords();
std::span<const std::string_view> effortWords();

const QualityPreset* qualityPreset(std::string_view name);

}  // namespace poinsot::scene
