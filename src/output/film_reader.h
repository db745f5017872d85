// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/rational.h"
#include "image/image.h"

namespace poinsot::output {

/// Returns whether a file has the extension of a readable film, in either case.
bool isFilmName(const std::filesystem::path& file);
bool isPictureOrFilmName(const std::filesystem::path& file);
/// Returns whether a file is a film: by its extension, or as an animated PNG by its content.
bool isFilm(const std::filesystem::path& file);

/// Most pixels of a film's picture that is decoded: 64 million, as for a PNG (image/png_file.h).
inline constexpr std::int64_t kMostFilmPixels = std::int64_t{64} << 20;

struct ShownPicture {
  image::AnyImage picture;
  double start_s = 0;     ///< from the container's own zero; NaN if the container gives none
  double duration_s = 0;  ///< 0 if the container gives none
};

/// Decoder of a film's pictures in presentation order, as sRGB of full range: RGB, or RGBA if the film has
/// transparency; 16 bits a sample if the film has more than 8. Reads every film that this program writes, and
/// films of other programs in the same containers and in AVI.
class FilmReader {
 public:
  /// Reads the size of the pictures from the film's header, without decoding; 0 if the header gives none.
  /// @throws core::Error(kIo) with the path.
  static image::PixelSize declaredSize(const std::filesystem::path& film);

  /// Opens a film and decodes its first pictures.
  /// @param mostPixels  limit for a picture. No larger one is decoded, even if the film's header states less.
  /// @throws core::Error(kIo) with the path if the file is unreadable, no film of a known kind, or damaged;
  /// core::Error(kLimit) if the pictures are too large. next() throws the same.
  explicit FilmReader(const std::filesystem::path& film, std::int64_t mostPixels = kMostFilmPixels);
  ~FilmReader();
  FilmReader(const FilmReader&) = delete;
  FilmReader& operator=(const FilmReader&) = delete;

  image::PixelSize size() const;
  bool isTransparent() const;
  /// Returns whether pictures have 16 bits a sample instead of 8.
  bool isDeep() const;
  /// Returns the bytes that reading takes at its peak, besides pictures that next() has returned: pictures that
  /// the decoder keeps as references, and to bring them into order.
  double memory_bytes() const;
  /// Returns the frames per second; 0 if the film gives none.
  core::Rational fps() const;
  /// Returns the unit in which the film counts its times.
  double timeStep_s() const;
  std::optional<ShownPicture> next();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot::output
