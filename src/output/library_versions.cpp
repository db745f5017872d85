// SPDX-License-Identifier: Apache-2.0
#include "output/library_versions.h"

#include <fmt/format.h>

#include <string_view>

#include "image/png_file.h"
#include "output/ffmpeg_encoder.h"
#include "output/film_frame.h"

namespace poinsot::output {
namespace {

std::string dotted(unsigned version) {
  return fmt::format("{}.{}.{}", AV_VERSION_MAJOR(version), AV_VERSION_MINOR(version), AV_VERSION_MICRO(version));
}

/// Extracts the version from x264's note: "core 164 r3095 baee400" from "x264 - core 164 r3095 baee400 -
/// H.264/...".
std::string versionIn(std::string_view note) {
  constexpr std::string_view kSeparator = " - ";
  const auto begin = note.find(kSeparator);
  if (begin == std::string_view::npos) return "";
  note.remove_prefix(begin + kSeparator.size());
  return std::string(note.substr(0, note.find(kSeparator)));
}

std::string x264Version() try {
  const image::Image grey({16, 16}, 3);
  FilmEncoder encoder(grey.size, {25, 1}, {});
  fillFrame(encoder.frame(), grey);
  encoder.encode([](AVPacket&) {});
  encoder.drain([](AVPacket&) {});
  return versionIn(encoder.note());
} catch (const core::Error&) {
  return "";
}

}  // namespace

std::vector<LibraryVersion> libraryVersions() {
  std::vector<LibraryVersion> versions = {{"libpng", image::libpngVersion()}};
  try {
    versions.push_back({"libavcodec", dotted(ffmpeg().avcodec_version())});
    versions.push_back({"libavformat", dotted(ffmpeg().avformat_version())});
  } catch (const core::Error& error) {
    versions.push_back({"FFmpeg", "not found: " + error.message()});
    return versions;
  }
  if (auto x264 = x264Version(); !x264.empty()) versions.push_back({"x264", std::move(x264)});
  return versions;
}

}  // namespace poinsot::output
