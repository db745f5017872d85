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

/// Limits and presets that the scene file and the command line share.
namespace poinsot::scene {

/// Limit on a scene or on its output. A user can raise a limit; a scene cannot.
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

/// Row of the table of limits. The command line options and the reference use this table.
struct LimitRow {
  std::string_view name;
  LimitUnit unit = LimitUnit::kCount;
  std::int64_t usual = 0;    ///< default of the limit; 0 means no limit
  std::int64_t highest = 0;  ///< largest value that a user can set
  std::string_view help;
};

/// Returns the rows of all limits, in the order of Limit.
std::span<const LimitRow> limitTable();
const LimitRow& rowOf(Limit limit);

/// Returns the default of a limit; 0 means no limit.
double usual(Limit limit);

/// Formats a value with the limit's unit, such as "4 MiB" or "8192 pixels".
std::string limitText(Limit limit, std::int64_t value);

/// Returns the end of an error message, such as "--limit side=N raises the limit".
std::string howToRaise(Limit limit);

class Limits {
 public:
  Limits();

  std::int64_t operator[](Limit limit) const { return values_.at(static_cast<std::size_t>(limit)); }
  std::size_t bytes(Limit limit) const { return static_cast<std::size_t>((*this)[limit]); }

  /// Sets a limit.
  /// @throws core::Error(kUsage) unless `value` is from 1 to LimitRow::highest.
  void set(Limit limit, std::int64_t value);
  /// Sets a limit to a value given as text, such as "16384" or, for bytes, "64 GiB".
  /// @throws core::Error(kUsage) if the text is malformed or the value out of range.
  void set(Limit limit, std::string_view value);
  /// Sets a limit given with its name, such as "side=16384".
  /// @throws core::Error(kUsage) if the name is unknown, the text malformed or the value out of range.
  void setByWord(std::string_view word);

  bool operator==(const Limits&) const = default;

 private:
  std::array<std::int64_t, kLimitCount> values_{};
};

/// Returns the limit with this name.
/// @throws core::Error(kUsage) for an unknown name, suggesting the most similar name.
Limit limitNamed(std::string_view name);

/// Permissions that the user grants to a scene: limits, and folders besides its own from which it may read.
struct Allowance {
  Limits limits;
  std::vector<std::filesystem::path> assetRoots;  ///< folders to search after the scene's folder, in this order
};

constexpr int kLeastSide = 16;
constexpr double kLeastMoment = 1e-60;  ///< of moments of inertia, in kg·m²; also of masses, in kg
constexpr double kMostMoment = 1e60;
constexpr double kLeastSpin = 1e-40;  ///< rad/s, for each component that is not 0
constexpr double kMostSpin = 1e40;
constexpr double kMostInstant_s = 1e20;  ///< largest absolute time; times a spin, it is a finite angle
constexpr double kMostTorque = 1e140;  ///< N·m, the largest moment of inertia times the square of the largest spin
constexpr double kMostRatioOfMoments = 1e20;  ///< largest moment over smallest moment, for physics::FreeMotion

constexpr std::size_t kMostLines = 40;  ///< lines of a note; more do not fit into a picture

/// Values that a word of the key `output.quality` sets. The keys output.size and output.crf override them.
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
