// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// Limits and presets of the output, shared by the scene file and the command line.
namespace poinsot::scene {

constexpr int kLeastSide = 16;
constexpr int kMostSide = 8192;  ///< llvmpipe can do 16 384; what a picture takes of memory: app/memory.h
constexpr std::int64_t kMostFrames = 36'000;  ///< twenty minutes at 30 frames a second
constexpr double kMostFps = 1000;
constexpr double kLongestFilm_s = 3600;
constexpr double kLeastMoment = 1e-60;  ///< kg·m², given or of a shape; a mass has the same limits in kg
constexpr double kMostMoment = 1e60;
constexpr double kLeastSpin = 1e-40;  ///< rad/s, of each component that is not zero
constexpr double kMostSpin = 1e40;
constexpr double kMostInstant_s = 1e20;       ///< either way; times the spin it is an angle
constexpr double kMostTorque = 1e140;         ///< N·m, a moment times the square of a spin
constexpr double kMostRatioOfMoments = 1e20;  ///< largest to smallest; physics::FreeMotion solves no more

constexpr std::size_t kMostElements = 1000;  ///< of an array of tables: parts, point masses, steps of a torque
constexpr std::size_t kMostLines = 40;       ///< of one note: what a picture can hold
constexpr std::size_t kMostFileBytes = std::size_t{64} << 20;  ///< of a file that a scene names

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
