// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/rational.h"
#include "image/image.h"

namespace poinsot::output {

enum class FilmContainer { kMp4, kMov, kWebm, kGif, kApng };
enum class FilmCodec { kH264, kHevc, kProRes, kVp9, kAv1, kGif, kApng };

/// Resolution of colour: one sample for each square of four pixels, or for each pixel.
enum class Chroma { k420, k444 };

/// Time that the encoder may take to find a smaller file of the same quality.
enum class Effort { kFast, kMedium, kSlow };

struct FilmFormat {
  FilmContainer container = FilmContainer::kMp4;
  FilmCodec codec = FilmCodec::kH264;
  Chroma chroma = Chroma::k420;
  Effort effort = Effort::kMedium;
  bool transparent = false;
  /// Rate factor on x264's scale: 0 is lossless, 18 shows no loss, 51 is worst. Other encoders with a rate factor
  /// get the value on their own scale that gives the same error.
  double crf = 18;
};

std::span<const FilmContainer> filmContainers();
/// Returns the container by the file's extension; nullopt if no film has that extension.
std::optional<FilmContainer> filmContainer(const std::filesystem::path& file);
/// Returns the container's name, which is also its file extension: "mp4".
std::string_view nameOf(FilmContainer container);
/// Returns the codecs that the container can hold, the default first.
std::span<const FilmCodec> codecsOf(FilmContainer container);

std::string_view nameOf(FilmCodec codec);
std::optional<FilmCodec> filmCodec(std::string_view name);

/// Returns whether the film is encoded as a whole when its segments are joined, as a GIF or an APNG is. Until then
/// the segments are lossless, because all frames of a GIF share one palette, and all frames of an APNG refer to
/// one another.
bool isMadeWhole(FilmContainer container);

/// Returns the file names of all containers, for messages: "NAME.mp4, NAME.mov, ...".
std::string filmFormatsText();

/// Checks that a film can be made in this format on this machine.
/// @throws core::Error(kUsage) if no such film exists, naming what is possible; core::Error(kEncode) naming the
/// library that is missing, or the encoder that this libavcodec lacks and the codecs for which it has one.
void checkFormat(const FilmFormat& format, image::PixelSize size, const core::Rational& fps);

}  // namespace poinsot::output
