// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "image/image.h"
#include "output/film_format.h"

namespace poinsot::output {

/// One decoded frame: luma and chroma planes without padding, and its time in the container's ticks.
struct DecodedFrame {
  std::int64_t pts = 0;
  bool key = false;
  std::vector<std::uint8_t> y, cb, cr;
};

/// Returns all frames of a film in the order shown, decoded by libavcodec.
std::vector<DecodedFrame> decoded(const std::filesystem::path& film);

/// Returns ffprobe's report on the first stream and the file: "width" -> "320", "tag:title" -> "...". Runs ffprobe
/// as a process.
std::map<std::string, std::string> probed(const std::filesystem::path& film);

/// Returns the first `count` pictures of a film as RGBA, as the program ffmpeg shows them by the file's own colour
/// tags. Empty if ffmpeg fails.
std::vector<image::Image> shown(const std::filesystem::path& film, image::PixelSize size, int count);

/// Returns the default film format with the rate factor `crf`.
FilmFormat h264(double crf);

/// Returns frame k of a test film: a bright disc that crosses a dark gradient, with a fine line; distinct for each
/// k.
image::Image movingDisc(image::PixelSize size, std::int64_t k);

}  // namespace poinsot::output
