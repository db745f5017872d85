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

/// Resolution of colour: k420 has one sample for each square of four pixels, k444 has one for each pixel.
enum class Chroma { k420, k444 };

/// Time that the encoder may take to find a smaller file of the same quality.
enum class Effort { kFast, kMedium, kSlow };

struct FilmFormat {
  FilmContainer container = FilmContainer::kMp4;
  FilmCodec codec = FilmCodec::kH264;
  Chroma chroma = Chroma::k420;
  Effort effort = Effort::kMedium;
  bool transparent = false;
  /// Rate factor on x264's scale: 0 is lossless, 18 has no visible loss, 51 is worst. For other encoders with a
  /// rate factor, this value is converted to their scale, so that the error is the same.
  double crf = 18;
};

std::span<const FilmContainer> filmContainers();
/// Returns the container that a file's extension selects; nullopt if no film has that extension.
std::optional<FilmContainer> filmContainer(const std::filesystem::path& file);
/// Returns the container's name, such as "mp4", which is also its file extension.
std::string_view nameOf(FilmContainer container);
/// Returns the codecs that the container can hold, the default first.
std::span<const FilmCodec> codecsOf(FilmContainer container);

std::string_view nameOf(FilmCodec codec);
std::optional<FilmCodec> filmCodec(std::string_view name);

/// Returns whether a film is encoded only when its segments are joined. This is so for a GIF, whose frames share
/// one palette, and for an APNG, whose frames refer to one another. Their segments are lossless.
bool isMadeWhole(FilmContainer container);

/// Returns the file names of all containers, for messages, such as "NAME.mp4, NAME.mov, ...".
std::string filmFormatsText();

/// Checks that a film can be made in this format on this machine.
/// @throws core::Error(kUsage) if the format is impossible, naming possible ones; core::Error(kEncode) if a
///   library or an encoder is missing, naming it and the codecs for which this libavcodec has an encoder.
void checkFormat(const FilmFormat& format, image::PixelSize size, const core::Rational& fps);

}  // namespace poinsot::output
