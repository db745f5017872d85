// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/rational.h"
#include "output/atomic_file.h"
#include "output/ffmpeg_handles.h"
#include "output/film.h"

namespace poinsot::output {

/// The container's clock: one frame is a whole number of ticks.
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

/// One H.264 track in an MP4 that appears under its name when finish() returns.
class Mp4Writer {
 public:
  enum class Index { kAtEnd, kAtStart };

  /// @throws core::Error(kIo) with the path, as do the members below.
  Mp4Writer(const std::filesystem::path& target, const AVCodecParameters& parameters, const FrameClock& clock,
            Index index, const std::vector<FilmText>& texts, const std::filesystem::path& temporaryFolder = {});
  Mp4Writer(const Mp4Writer&) = delete;
  Mp4Writer& operator=(const Mp4Writer&) = delete;

  /// The next packet in decoding order; `frame` is its place in the shown order. Consumes the packet's times only.
  void write(AVPacket& packet, std::int64_t frame);
  void finish();

 private:
  int check(int code, std::string_view doing) const;
  void checkIo() const;

  // The order of destruction matters: the format uses the buffer, and that the file.
  AtomicFile file_;
  IoPtr io_;
  FormatOutputPtr format_;
  FrameClock clock_;
  std::int64_t packets_ = 0;
};

/// The packets of the one video track of an MP4.
class Mp4Reader {
 public:
  /// @throws core::Error(kIo) with the path if it is no readable MP4 with a video track.
  explicit Mp4Reader(const std::filesystem::path& path);

  const AVCodecParameters& parameters() const { return *format_->streams[0]->codecpar; }
  AVRational timeBase() const { return format_->streams[0]->time_base; }
  /// What the file names as its encoder; empty if nothing.
  std::string mark() const { return text("encoder"); }  // libav writes the box as "encoding_tool"
  /// A text of the file's own; empty if there is none of that name.
  std::string text(const char* key) const;
  /// False after the last packet. Times as stored, edit lists not applied.
  bool next(AVPacket& packet);

 private:
  std::filesystem::path path_;
  FormatInputPtr format_;
};

}  // namespace poinsot::output
