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

struct FilmTexts {
  std::string title = {}, description = {};
  std::string origin = {};  ///< identifies the film's source data; stored with the film's digest
  std::string renderer = {};
};

/// Largest palette of a GIF. One of its 256 indices marks pixels that are unchanged since the previous picture.
inline constexpr int kMostColors = 255;

struct FilmTrack {
  FilmContainer container = FilmContainer::kMp4;
  core::Rational fps;
  int colors = kMostColors;  ///< colours in the palette of a GIF, from 2 to kMostColors; unused in other films
};

/// Joins segments of VideoSegmentWriter into a film, in the given order. The same segments give the same bytes. A
/// GIF or an APNG (isMadeWhole()) is encoded here. For other containers, the encoded pictures are copied, and the
/// index is placed first, so that playback can start before the whole file has arrived. The film gets its name
/// only when it is complete and synced.
/// @param temporaryFolder  folder of the incomplete film, as for core::AtomicFile.
/// @throws core::Error(kIo) naming the file if a segment is unreadable, damaged, of another frame rate, or encoded
///   with other settings than the first (size, encoder header), or if the film cannot be written.
void joinSegments(const std::vector<std::filesystem::path>& segments, const std::filesystem::path& target,
                  const FilmTrack& track, const FilmTexts& texts = {},
                  const std::filesystem::path& temporaryFolder = {});

/// Makes the same film as joinSegments(), without naming it. The complete film gets its name by core::FileBatch.
[[nodiscard]] core::AtomicFile joinedSegments(const std::vector<std::filesystem::path>& segments,
                                              const std::filesystem::path& target, const FilmTrack& track,
                                              const FilmTexts& texts = {},
                                              const std::filesystem::path& temporaryFolder = {});

/// Callback that receives consecutive bytes. @returns 0 or an errno.
using ByteSink = std::function<int(std::span<const std::uint8_t>)>;

/// Sends a film as a fragmented MP4, one segment at a time. Bytes that were sent never change.
class FilmStream {
 public:
  /// @pre the container is an MP4.
  FilmStream(ByteSink sink, const FilmTrack& track);
  ~FilmStream();
  FilmStream(const FilmStream&) = delete;
  FilmStream& operator=(const FilmStream&) = delete;

  /// Sends the pictures of the next segment. @throws core::Error(kIo) as joinSegments(); core::BrokenPipe.
  void append(const std::filesystem::path& segment);
  /// Ends the film. Call after at least one append().
  void finish();

 private:
  struct Parts;
  ByteSink sink_;
  FilmTrack track_;
  std::unique_ptr<Parts> parts_;
};

enum class FilmState {
  kOther,    ///< no file, or not a film of this origin
  kDamaged,  ///< a film of this origin whose bytes have changed
  kWhole,    ///< a film of this origin whose bytes have not changed
};

/// Compares a film's bytes with the digest that the film stores. Returns kOther if the file cannot be read.
FilmState filmState(const std::filesystem::path& film, const std::string& origin);

/// Returns whether a film's bytes are still those that were written. The origin of the film does not matter.
bool isWholeFilm(const std::filesystem::path& film);

/// Returns whether this program wrote the film. This is so if the file has this program's mark or a film's digest,
/// and names no other program as its writer. Returns false if the file cannot be opened.
bool isOwnFilm(const std::filesystem::path& path);

}  // namespace poinsot::output
