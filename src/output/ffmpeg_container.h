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

/// File format of a film or of a segment. Segments of a GIF or an APNG are Matroska files.
enum class FileFormat { kMp4, kMov, kWebm, kGif, kApng, kMatroska };

FileFormat fileFormat(FilmContainer container);
FileFormat segmentFormat(FilmContainer container);

/// Clock of an MP4. A second has `timescale` ticks, and each frame lasts `ticks` of them.
struct FrameClock {
  int timescale = 0;
  int ticks = 0;
  friend bool operator==(const FrameClock&, const FrameClock&) = default;
};

/// Returns an exact clock for a frame rate. The timescale is the numerator of the rate, doubled until it is at
/// least 10000, as libavformat would choose it.
/// @throws core::Error(kUsage) for a rate without an exact clock, such as 1/1000000.
FrameClock frameClock(const core::Rational& fps);

/// Returns the mark that this program stores in its films: its name and version, such as "poinsot 0.1.0".
std::string ownMark();

/// Position of the index that a player reads before it can show the film.
enum class Index {
  kAtEnd,
  kAtStart,   ///< playback can start before the whole file has arrived
  kInPieces,  ///< MP4 only: one index per group of frames; written bytes never change
};

struct ByteTarget {
  ByteSink sink;
  std::string name;
  int descriptor = -1;              ///< file descriptor for seeking; -1 for a stream
  std::filesystem::path file = {};  ///< path of the file; required for Index::kAtStart, which reads it again
};

class TrackMuxer {
 public:
  /// @throws core::Error(kIo) with the target's name, or core::BrokenPipe; as do the members below.
  TrackMuxer(ByteTarget target, FileFormat format, const AVCodecParameters& parameters, const core::Rational& fps,
             Index index, const FilmTexts& texts);
  TrackMuxer(const TrackMuxer&) = delete;
  TrackMuxer& operator=(const TrackMuxer&) = delete;

  /// Writes a packet. Packets must come in decoding order. Changes only the times, position and stream index of
  /// the packet.
  /// @param frame  number of the packet's frame in presentation order
  void write(AVPacket& packet, std::int64_t frame);
  /// Writes the index after the last packet, and flushes all bytes to the system.
  void finish();

 private:
  int check(int code, std::string_view doing) const;
  std::int64_t ticksAt(std::int64_t frame) const;

  ByteTarget target_;
  // Must be declared before format_, which uses this buffer until it is destroyed.
  IoPtr io_;
  FormatOutputPtr format_;
  AVRational frame_s_;
  std::int64_t reorderDelay_;
  std::int64_t packets_ = 0;
};

/// Writes a film's file with a TrackMuxer. If the texts name an origin, the file also stores a digest of its own
/// bytes.
class TrackWriter {
 public:
  /// @throws core::Error(kIo) with the path; as do the members below.
  TrackWriter(const std::filesystem::path& target, FileFormat format, const AVCodecParameters& parameters,
              const core::Rational& fps, Index index, const FilmTexts& texts,
              const std::filesystem::path& temporaryFolder = {});
  TrackWriter(const TrackWriter&) = delete;
  TrackWriter& operator=(const TrackWriter&) = delete;

  void write(AVPacket& packet, std::int64_t frame) { muxer_.write(packet, frame); }
  /// Finishes the file. Call after the last packet. @returns the complete file, which gets its name by commit().
  [[nodiscard]] core::AtomicFile finish();

 private:
  core::AtomicFile file_;
  FileFormat format_;
  FilmTexts texts_;
  TrackMuxer muxer_;
};

/// Reads the packets of a file that has one video track and no other tracks.
class TrackReader {
 public:
  /// @throws core::Error(kIo) with the path if the file is unreadable, of another format, or not one video track.
  TrackReader(const std::filesystem::path& path, FileFormat format);

  const AVCodecParameters& parameters() const { return *format_->streams[0]->codecpar; }
  AVRational timeBase() const { return format_->streams[0]->time_base; }
  /// Returns the program that wrote the file, such as "poinsot 0.1.0", from the file's metadata; may be empty.
  std::string mark() const;
  /// Returns whether another program wrote the file but copied the texts of a film, as `ffmpeg -c copy` does.
  bool namesOtherWriter() const;
  /// Returns the text that contains the film's origin; empty if there is none.
  std::string comment() const;
  /// Reads the next packet. Returns false after the last packet. Times are as stored; edit lists are ignored.
  bool next(AVPacket& packet);

 private:
  std::string tag(const std::string& name) const;

  std::filesystem::path path_;
  FileFormat kind_;
  FormatInputPtr format_;
};

}  // namespace poinsot::output
