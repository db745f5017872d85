// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/atomic_file.h"
#include "core/rational.h"
#include "output/ffmpeg_handles.h"
#include "output/film.h"

namespace poinsot::output {

/// File formats for one track of packets. Segments of a GIF or an APNG are Matroska files.
enum class FileFormat { kMp4, kMov, kWebm, kGif, kApng, kMatroska };

FileFormat fileFormat(FilmContainer container);
FileFormat segmentFormat(FilmContainer container);

/// Clock of an MP4: `timescale` ticks per second, and a whole number of `ticks` per frame.
struct FrameClock {
  int timescale = 0;
  int ticks = 0;
  friend bool operator==(const FrameClock&, const FrameClock&) = default;
};

/// Returns an exact clock for a frame rate. The timescale is the rate's numerator, doubled until it is at least
/// 10000, which is what libavformat would choose.
/// @throws core::Error(kUsage) for a rate without an exact clock, such as 1/1000000.
FrameClock frameClock(const core::Rational& fps);

/// Returns the encoder name that this program writes into its films: "poinsot 0.1.0".
std::string ownMark();

/// Position of the index that a player reads before it can show the film.
enum class Index {
  kAtEnd,
  kAtStart,   ///< playback can start before the whole file has arrived
  kInPieces,  ///< MP4 only: an index with each piece from key frame to key frame; written bytes never change
};

struct ByteTarget {
  ByteSink sink;
  std::string name;
  int descriptor = -1;              ///< file descriptor to seek in; -1 for a stream
  std::filesystem::path file = {};  ///< path to read the file again, needed for an index at the start
};

class TrackMuxer {
 public:
  /// @throws core::Error(kIo) with the target's name, or core::BrokenPipe; so do the members below.
  TrackMuxer(ByteTarget target, FileFormat format, const AVCodecParameters& parameters, const core::Rational& fps,
             Index index, const FilmTexts& texts);
  TrackMuxer(const TrackMuxer&) = delete;
  TrackMuxer& operator=(const TrackMuxer&) = delete;

  /// Writes the next packet in decoding order. `frame` is the packet's place in presentation order. Changes only
  /// the times, position and stream index of the packet.
  void write(AVPacket& packet, std::int64_t frame);
  /// Writes the index after the last packet, and flushes all bytes to the system.
  void finish();

 private:
  int check(int code, std::string_view doing) const;
  std::int64_t ticksAt(std::int64_t frame) const;

  ByteTarget target_;
  // Declared before format_, which uses the buffer until its own destruction.
  IoPtr io_;
  FormatOutputPtr format_;
  AVRational frame_s_;
  std::int64_t reorderDelay_;
  std::int64_t packets_ = 0;
};

/// File that a TrackMuxer writes. If the texts name an origin, the file also stores the digest of its bytes.
class TrackWriter {
 public:
  /// @throws core::Error(kIo) with the path; so do the members below.
  TrackWriter(const std::filesystem::path& target, FileFormat format, const AVCodecParameters& parameters,
              const core::Rational& fps, Index index, const FilmTexts& texts,
              const std::filesystem::path& temporaryFolder = {});
  TrackWriter(const TrackWriter&) = delete;
  TrackWriter& operator=(const TrackWriter&) = delete;

  void write(AVPacket& packet, std::int64_t frame) { muxer_.write(packet, frame); }
  /// Ends the file after the last packet. @returns the complete file, which has no name until commit().
  [[nodiscard]] core::AtomicFile finish();

 private:
  core::AtomicFile file_;
  FileFormat format_;
  FilmTexts texts_;
  TrackMuxer muxer_;
};

/// Reader of the packets of a file's only video track.
class TrackReader {
 public:
  /// @throws core::Error(kIo) with the path if the file is unreadable, of another format, or not one video track.
  TrackReader(const std::filesystem::path& path, FileFormat format);

  const AVCodecParameters& parameters() const { return *format_->streams[0]->codecpar; }
  AVRational timeBase() const { return format_->streams[0]->time_base; }
  /// Returns the encoder that the file names; empty if it names none.
  std::string mark() const;
  /// Returns whether another program wrote the file but copied the texts of a film, as `ffmpeg -c copy` does.
  bool namesOtherWriter() const;
  /// Returns the text that holds the film's origin; empty if there is none.
  std::string comment() const;
  /// Reads the next packet, with times as stored, without edit lists. Returns false after the last packet.
  bool next(AVPacket& packet);

 private:
  std::string tag(const std::string& name) const;

  std::filesystem::path path_;
  FileFormat kind_;
  FormatInputPtr format_;
};

}  // namespace poinsot::output
