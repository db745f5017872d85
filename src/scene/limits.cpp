// SPDX-License-Identifier: Apache-2.0
#include "scene/limits.h"

#include <algorithm>
#include <iterator>

namespace poinsot::scene {
namespace {

// At CRF 18, films of flat colours and thin lines have no visible loss. Previews have smaller files instead.
constexpr QualityPreset kPresets[] = {
    {"preview", 640, 360, 23}, {"720p", 1280, 720, 20}, {"1080p", 1920, 1080, 18}, {"4k", 3840, 2160, 18}};

}  // namespace

std::span<const QualityPreset> qualityPresets() { return kPresets; }

std::span<const std::string_view> codecWords() {
  static constexpr std::string_view kWords[] = {"h264", "hevc", "vp9", "av1", "prores"};
  return kWords;
}

std::span<const std::string_view> chromaWords() {
  static constexpr std::string_view kWords[] = {"4:2:0", "4:4:4"};
  return kWords;
}

std::span<const std::string_view> effortWords() {
  static constexpr std::string_view kWords[] = {"fast", "medium", "slow"};
  return kWords;
}

const QualityPreset* qualityPreset(std::string_view name) {
  const auto found = std::find_if(std::begin(kPresets), std::end(kPresets),
                                  [&](const QualityPreset& preset) { return preset.name == name; });
  return found == std::end(kPresets) ? nullptr : found;
}

}  // namespace poinsot::scene
