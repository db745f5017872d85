// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/rational.h"
#include "image/image.h"

namespace poinsot::output {

/// Returns whether a file has the extension of a readable film, in lower or upper case.
bool isFilmName(const std::filesystem::path& file);
bool isPictureOrFilmName(const std::filesystem::path& file);
/// Returns whether a file is a film, by its extension. An animated PNG is recognised by its content.
bool isFilm(const std::filesystem::path& file);

/// Largest picture of a film that is decoded, in pixels: 64 million, as for a PNG (image/png_file.h).
inline constexpr std::int64_t kMostFilmPixels = std::int64_t{64} << 20;

struct ShownPicture {
  image::AnyImage picture;
  double start_s = 0;     ///< time in the container, in seconds; NaN if unknown
  double duration_s = 0;  ///< in seconds; 0 if unknown
};

/// Decodes a film's pictures in presentation order. Pictures are sRGB of full range: RGB, or RGBA if the film has
/// transparency. They have 16 bits a sample if the film has more than 8. Reads every film that this program
/// writes, and films of other programs in the same containers and in AVI.
class FilmReader {
 public:
  /// Reads the size of the pictures from the film's header, without decoding; 0 if the header gives none.
  /// @throws core::Error(kIo) with the path.
  static image::PixelSize declaredSize(const std::filesystem::path& film);

  /// Opens a film and decodes its first picture.
  /// @param mostPixels  largest picture to decode, in pixels, even if the header states a smaller size.
  /// @throws core::Error(kIo) with the path if the file is unreadable, no film of a known kind, or damaged;
  ///   core::Error(kLimit) if the pictures are too large. next() throws the same.
  explicit FilmReader(const std::filesystem::path& film, std::int64_t mostPixels = kMostFilmPixels);
  ~FilmReader();
  FilmReader(const FilmReader&) = delete;
  FilmReader& operator=(const FilmReader&) = delete;

  image::PixelSize size() const;
  bool isTransparent() const;
  /// Returns whether pictures have 16 bits a sample instead of 8.
  bool isDeep() const;
  /// Returns the peak memory for reading the film, in bytes. This includes pictures that the decoder keeps as
  /// references or until they are shown, but not pictures that next() has returned.
  double memory_bytes() const;
  /// Returns the frames per second; 0 if the film does not state them.
  core::Rational fps() const;
  /// Returns the time unit of the film, in seconds.
  double timeStep_s() const;
  std::optional<ShownPicture> next();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot::output
