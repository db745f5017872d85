// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/rational.h"
#include "image/image.h"

namespace poinsot::output {

/// Whether its name, in capitals or not, says that a file is a film that may be read here.
bool isFilmName(const std::filesystem::path& file);
/// Whether its name says that a file is a PNG or such a film.
bool isPictureOrFilmName(const std::filesystem::path& file);
/// Like isFilmName(), but by what is in the file where its name may mean both: a .png with an animation is a film.
bool isFilm(const std::filesystem::path& file);

/// Pixels of a picture of a film that is decoded: 64 million, as of a PNG (image/png_file.h).
inline constexpr std::int64_t kMostFilmPixels = std::int64_t{64} << 20;

/// A picture of a film, and when it is shown.
struct ShownPicture {
  image::AnyImage picture;
  double start_s = 0;     ///< as the container says, from any zero; not a number where it says nothing
  double duration_s = 0;  ///< 0 where the container says nothing
};

/// The pictures of a film in the order they are shown, as sRGB of full range: RGB, or RGBA where the film has
/// transparency; with 16 bits a sample where the film has more than 8. Reads every film that this program writes,
/// and those of others in the same containers and AVI.
class FilmReader {
 public:
  /// Reads the size of the pictures from the film's header; nothing is decoded. 0 where the header says nothing.
  /// @throws core::Error(kIo) with the path.
  static image::PixelSize declaredSize(const std::filesystem::path& film);

  /// Opening a film decodes its first pictures.
  /// @param mostPixels  of a picture; none with more is decoded, whatever the film's header says.
  /// @throws core::Error(kIo) with the path, as does next(): unreadable, no such film, damaged; (kLimit) too
  /// large.
  explicit FilmReader(const std::filesystem::path& film, std::int64_t mostPixels = kMostFilmPixels);
  ~FilmReader();
  FilmReader(const FilmReader&) = delete;
  FilmReader& operator=(const FilmReader&) = delete;

  image::PixelSize size() const;
  /// Whether pictures have transparency, and 16 bits a sample.
  bool isTransparent() const;
  bool isDeep() const;
  /// Bytes that reading takes at its peak, besides pictures that next() has returned: pictures that the decoder
  /// keeps to refer to, and to bring into order.
  double memory_bytes() const;
  /// Frames per second; 0 if the film says nothing.
  core::Rational fps() const;
  /// Unit in which the film counts its times.
  double timeStep_s() const;
  /// The next picture; nothing after the last.
  std::optional<ShownPicture> next();

 private:
  struct Parts;  // keeps libav's headers out of this one
  std::unique_ptr<Parts> parts_;
};

}  // namespace poinsot::output
