// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "core/rational.h"
#include "output/film_format.h"

namespace poinsot::output {

/// Texts kept in a film.
struct FilmTexts {
  std::string title = {}, description = {};
  std::string origin =
      {};  ///< what the film was made from; no other film has it. It is kept with the film's digest.
  std::string renderer = {};  ///< what drew it
};

/// What a film is, besides its pictures.
struct FilmTrack {
  FilmContainer container = FilmContainer::kMp4;
  core::Rational fps;
};

/// Makes a film of segments written by VideoSegmentWriter, in this order. Where isMadeWhole() does not hold, the
/// encoded pictures are taken as they are, one after the other, and the index comes first (a player can start
/// before it has all). The same segments give the same bytes. The film appears under its name only when complete
/// and synced.
/// @throws core::Error(kIo) naming the file: unreadable or damaged, of another frame rate, or made with other
/// settings
///         than the first (size, encoder header); or the film cannot be written.
/// `temporaryFolder`: as of AtomicFile.
void joinSegments(const std::vector<std::filesystem::path>& segments, const std::filesystem::path& target,
                  const FilmTrack& track, const FilmTexts& texts = {},
                  const std::filesystem::path& temporaryFolder = {});

/// Makes the same film as joinSegments(), complete and synced, without its name: a batch gives it that.
[[nodiscard]] core::AtomicFile joinedSegments(const std::vector<std::filesystem::path>& segments,
                                              const std::filesystem::path& target, const FilmTrack& track,
                                              const FilmTexts& texts = {},
                                              const std::filesystem::path& temporaryFolder = {});

/// Takes bytes in their order. @returns 0 or an errno.
using ByteSink = std::function<int(std::span<const std::uint8_t>)>;

/// An MP4 that is sent on while it is made, in pieces of a segment: what is written is never touched again.
class FilmStream {
 public:
  /// @pre an MP4.
  FilmStream(ByteSink sink, const FilmTrack& track);
  ~FilmStream();
  FilmStream(const FilmStream&) = delete;
  FilmStream& operator=(const FilmStream&) = delete;

  /// The next segment's pictures. @throws core::Error(kIo) as joinSegments(); core::BrokenPipe.
  void append(const std::filesystem::path& segment);
  /// After at least one.
  void finish();

 private:
  struct Parts;  // keeps libav's headers out of this one
  ByteSink sink_;
  FilmTrack track_;
  std::unique_ptr<Parts> parts_;
};

/// The state of the file that has the name of a film.
enum class FilmState {
  kOther,    ///< nothing, or no film of this origin
  kDamaged,  ///< a film of this origin, of which bytes have changed
  kWhole,    ///< a film of this origin, byte for byte the one that was written
};

/// Compares every byte of a film with the digest that it keeps.
FilmState filmState(const std::filesystem::path& film, const std::string& origin);

/// Whether a film is, byte for byte, as it was written, whatever its origin.
bool isWholeFilm(const std::filesystem::path& film);

/// Returns whether the file is a film written by this program: it holds the mark or the digest of one, and names
/// no other program as its writer. False for a file that cannot be opened.
bool isOwnFilm(const std::filesystem::path& path);

}  // namespace poinsot::output
