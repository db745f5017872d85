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

/// The kinds of file that hold one track of packets. Segments of films that are made whole lie in Matroska.
enum class FileFormat { kMp4, kMov, kWebm, kGif, kApng, kMatroska };

FileFormat fileFormat(FilmContainer container);
FileFormat segmentFormat(FilmContainer container);

/// MP4's clock: one frame is a whole number of ticks.
struct FrameClock {
  int timescale = 0;  ///< ticks per second
  int ticks = 0;      ///< ticks per frame
  friend bool operator==(const FrameClock&, const FrameClock&) = default;
};

/// The frame rate's numerator, doubled until it is at least 10000 (what libavformat would do by itself).
/// @throws core::Error(kUsage) for rates such as 1/1000000.
FrameClock frameClock(const core::Rational& fps);

/// What this program writes into its films as their encoder: "poinsot 0.1.0".
std::string ownMark();

/// Where a file keeps what a player must know first.
enum class Index {
  kAtEnd,
  kAtStart,   ///< a player can start before it has all
  kInPieces,  ///< MP4 only: with each piece from key frame to key frame; nothing written is touched again
};

/// Where the bytes of a film go.
struct ByteTarget {
  ByteSink sink;
  std::string name;                 ///< for messages
  int descriptor = -1;              ///< of a file: where its place is set
  std::filesystem::path file = {};  ///< by which it can be read again, for an index at the start
};

/// One track of pictures, as a file of some kind.
class TrackMuxer {
 public:
  /// @throws core::Error(kIo) with the target's name, or core::BrokenPipe, as do the members below.
  TrackMuxer(ByteTarget target, FileFormat format, const AVCodecParameters& parameters, const core::Rational& fps,
             Index index, const FilmTexts& texts);
  TrackMuxer(const TrackMuxer&) = delete;
  TrackMuxer& operator=(const TrackMuxer&) = delete;

  /// The next packet in decoding order; `frame` is its place in the shown order. Consumes the packet's times only.
  void write(AVPacket& packet, std::int64_t frame);
  /// After the last packet: all is with the system when it returns.
  void finish();

 private:
  int check(int code, std::string_view doing) const;
  std::int64_t ticksAt(std::int64_t frame) const;

  ByteTarget target_;
  // The order of destruction matters: the format uses the buffer.
  IoPtr io_;
  FormatOutputPtr format_;
  AVRational frame_s_;
  std::int64_t reorderDelay_;
  std::int64_t packets_ = 0;
};

/// A TrackMuxer's file, with the digest of its bytes if the texts name its origin.
class TrackWriter {
 public:
  /// @throws core::Error(kIo) with the path, as do the members below.
  TrackWriter(const std::filesystem::path& target, FileFormat format, const AVCodecParameters& parameters,
              const core::Rational& fps, Index index, const FilmTexts& texts,
              const std::filesystem::path& temporaryFolder = {});
  TrackWriter(const TrackWriter&) = delete;
  TrackWriter& operator=(const TrackWriter&) = delete;

  void write(AVPacket& packet, std::int64_t frame) { muxer_.write(packet, frame); }
  /// After the last packet. @returns the complete file, which has no name yet.
  [[nodiscard]] core::AtomicFile finish();

 private:
  core::AtomicFile file_;
  FileFormat format_;
  FilmTexts texts_;
  TrackMuxer muxer_;
};

/// The packets of the one video track of a file.
class TrackReader {
 public:
  /// @throws core::Error(kIo) with the path if it is no readable file of that kind with a video track.
  TrackReader(const std::filesystem::path& path, FileFormat format);

  const AVCodecParameters& parameters() const { return *format_->streams[0]->codecpar; }
  AVRational timeBase() const { return format_->streams[0]->time_base; }
  /// What the file names as its encoder; empty if nothing.
  std::string mark() const;
  /// Returns whether a program that keeps the texts of the films it copies, such as `ffmpeg -c copy`, wrote the
  /// file.
  bool namesOtherWriter() const;
  /// Returns the text in which the origin is; empty if there is none.
  std::string comment() const;
  /// False after the last packet. Times as stored, edit lists not applied.
  bool next(AVPacket& packet);

 private:
  std::string tag(const std::string& name) const;

  std::filesystem::path path_;
  FileFormat kind_;
  FormatInputPtr format_;
};

}  // namespace poinsot::output
