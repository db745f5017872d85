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

/// How finely colour is kept: for each pixel, or for each square of four.
enum class Chroma { k420, k444 };

/// How long the encoder may look for a smaller file of the same quality.
enum class Effort { kFast, kMedium, kSlow };

/// How pictures become a film.
struct FilmFormat {
  FilmContainer container = FilmContainer::kMp4;
  FilmCodec codec = FilmCodec::kH264;
  Chroma chroma = Chroma::k420;
  Effort effort = Effort::kMedium;
  bool transparent = false;
  /// Rate factor on the scale of x264: 0 is lossless, 18 shows no loss, 51 is worst. The other encoders with a
  /// rate factor get the value of theirs that gives the same error.
  double crf = 18;
};

std::span<const FilmContainer> filmContainers();
/// By the extension; nothing where no film has that.
std::optional<FilmContainer> filmContainer(const std::filesystem::path& file);
/// "mp4": extension and name.
std::string_view nameOf(FilmContainer container);
/// What goes into it, the usual one first.
std::span<const FilmCodec> codecsOf(FilmContainer container);

/// "h264".
std::string_view nameOf(FilmCodec codec);
std::optional<FilmCodec> filmCodec(std::string_view name);

/// Whether frames are kept as they are while a film is made and encoded when it is put together: those of a GIF
/// share one palette, those of an APNG refer to one another from the first to the last.
bool isMadeWhole(FilmContainer container);

/// "NAME.mp4 (H.264, HEVC), ...", for messages.
std::string filmFormatsText();

/// @throws core::Error(kUsage) if there is no such film, saying what there is; core::Error(kEncode) naming the
/// library that is not there, or the encoder that this libavcodec lacks, and what can be made with those it has.
void checkFormat(const FilmFormat& format, image::PixelSize size, const core::Rational& fps);

}  // namespace poinsot::output
