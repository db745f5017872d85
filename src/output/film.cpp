// SPDX-License-Identifier: Apache-2.0
// The time of a frame is its number in the film times the ticks of one frame, both integers. Times in the
// segments' files are not copied. Segments of any length therefore join without gaps or overlaps.
#include "output/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "core/expect.h"
#include "core/text.h"
#include "output/animation.h"
#include "output/animation_text.h"
#include "output/ffmpeg_container.h"
#include "output/ffmpeg_encoder.h"
#include "output/film_seal.h"

namespace poinsot::output {
namespace {

using core::Error;
using std::filesystem::path;

[[noreturn]] void refuseFilm(const path& segment, std::string_view reason) {
  throw core::ioError(fmt::format("{}: {}", core::printable(segment.native()), reason));
}

class Segment {
 public:
  Segment(path file, const FilmTrack& track)
      : file_(std::move(file)),
        reader_(file_, segmentFormat(track.container)),
        packet_(checkAlloc(PacketPtr(ffmpeg().av_packet_alloc()))),
        frameTicks_(av_inv_q(ffmpeg().av_mul_q({static_cast<int>(track.fps.num), static_cast<int>(track.fps.den)},
                                               reader_.timeBase()))) {
    // In an MP4, the mark is at the very end of the file. This check therefore also detects a truncated file.
    if (reader_.mark() != ownMark()) refuseFilm(file_, "is not a segment written by this version of poinsot");
    if (!advance()) refuseFilm(file_, "has no frames");
    if ((packet_->flags & AV_PKT_FLAG_KEY) == 0) refuseFilm(file_, "does not start with a key frame");
    if (frameTicks_.num <= 0 || frameTicks_.den <= 0) refuseFilm(file_, "has a clock that does not fit the film");
    firstPts_ = packet_->pts;
    // Matroska rounds times to milliseconds, so one tick of difference is allowed there.
    const double off = std::abs(static_cast<double>(packet_->duration) - av_q2d(frameTicks_));
    if (off > (isMadeWhole(track.container) || track.container == FilmContainer::kWebm ? 1 : 0))
      refuseFilm(file_, "has another frame rate than the film");
  }

  AVPacket& packet() { return *packet_; }
  bool advance() { return reader_.next(*packet_); }
  const path& file() const { return file_; }
  const AVCodecParameters& parameters() const { return reader_.parameters(); }

  /// Returns the number of the packet's frame in presentation order. The first packet is a key frame and has
  /// number 0.
  std::int64_t frame() const {
    // Also rejects AV_NOPTS_VALUE, the smallest integer. The difference of two accepted times cannot overflow.
    constexpr std::int64_t kFarthest = std::int64_t{1} << 61;
    if (std::min(packet_->pts, firstPts_) < -kFarthest || std::max(packet_->pts, firstPts_) > kFarthest)
      refuseFilm(file_, "has a frame without a time");
    const std::int64_t ticks = packet_->pts - firstPts_;
    const std::int64_t frame = ffmpeg().av_rescale_q(ticks, {1, 1}, frameTicks_);
    if (ticks < 0 || ffmpeg().av_rescale_q(frame, frameTicks_, {1, 1}) != ticks)
      refuseFilm(file_, "has a frame at a time between two frames");
    if (frame > kLastFrame) refuseFilm(file_, fmt::format("has frame number {}, which is too large", frame));
    return frame;
  }

 private:
  // Largest frame number of a segment. No segment is so long, and the film's times do not overflow up to this
  // number.
  static constexpr std::int64_t kLastFrame = 100'000;

  path file_;
  TrackReader reader_;
  PacketPtr packet_;
  AVRational frameTicks_;
  std::int64_t firstPts_ = 0;
};

/// Returns the encoder header, or an empty span. memcmp() is not used, because it must not be given a null
/// pointer.
std::span<const std::uint8_t> bytesOf(const AVCodecParameters& p) {
  return {p.extradata, static_cast<std::size_t>(p.extradata_size)};
}

bool sameHeader(const AVCodecParameters& a, const AVCodecParameters& b) {
  return a.codec_id == b.codec_id && a.width == b.width && a.height == b.height &&
         std::ranges::equal(bytesOf(a), bytesOf(b));
}

void checkLike(const Segment& first, const Segment& segment) {
  if (!sameHeader(first.parameters(), segment.parameters()))
    refuseFilm(segment.file(),
               fmt::format("was encoded with other settings than {}", core::printable(first.file().native())));
}

/// Appends all packets of a segment to the film. Returns the number of frames.
/// @param start  number of the segment's first frame in the film
template <class Film>
std::int64_t append(Segment& segment, std::int64_t start, Film& film) {
  const std::int64_t delay = reorderDelay(segment.parameters().codec_id);
  std::vector<std::int64_t> frames;
  do {
    frames.push_back(segment.frame());
    // The encoder moves a frame back by at most `delay` packets; if it is more, the segment is damaged. The muxer
    // relies on this check.
    if (static_cast<std::int64_t>(frames.size()) - 1 - delay > frames.back())
      refuseFilm(segment.file(), "has its frames in an order that cannot be played");
    film.write(segment.packet(), start + frames.back());
  } while (segment.advance());
  std::sort(frames.begin(), frames.end());
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (frames[i] != static_cast<std::int64_t>(i)) refuseFilm(segment.file(), fmt::format("lacks frame {}", i));
  return static_cast<std::int64_t>(frames.size());
}

std::string originOf(const path& film, FilmContainer container) {
  if (!isMadeWhole(container)) return originIn(TrackReader(film, fileFormat(container)).comment());
  std::string origin;
  for (const std::string& text : animationTexts(film))
    if (origin.empty()) origin = originIn(text);
  return origin;
}

}  // namespace

void joinSegments(const std::vector<path>& segments, const path& target, const FilmTrack& track,
                  const FilmTexts& texts, const path& temporaryFolder) {
  joinedSegments(segments, target, track, texts, temporaryFolder).commit();
}

core::AtomicFile joinedSegments(const std::vector<path>& segments, const path& target, const FilmTrack& track,
                                const FilmTexts& texts, const path& temporaryFolder) {
  POINSOT_EXPECT(!segments.empty());
  if (isMadeWhole(track.container)) return animate(segments, target, track, texts, temporaryFolder);
  const Segment first(segments.front(), track);
  TrackWriter film(target, fileFormat(track.container), first.parameters(), track.fps, Index::kAtStart, texts,
                   temporaryFolder);
  std::int64_t frames = 0;
  for (const path& file : segments) {
    Segment segment(file, track);
    checkLike(first, segment);
    frames += append(segment, frames, film);
  }
  return film.finish();
}

struct FilmStream::Parts {
  Parts(const ByteSink& sink, const FilmTrack& filmTrack, const path& first)
      : track(filmTrack),
        example(first, track),
        film({sink, "standard output"}, fileFormat(track.container), example.parameters(), track.fps,
             Index::kInPieces, {}) {}

  FilmTrack track;
  Segment example;
  TrackMuxer film;
  std::int64_t frames = 0;
};

FilmStream::FilmStream(ByteSink sink, const FilmTrack& track) : sink_(std::move(sink)), track_(track) {
  POINSOT_EXPECT(track.container == FilmContainer::kMp4);
}

FilmStream::~FilmStream() = default;

void FilmStream::append(const path& segmentFile) {
  if (!parts_) parts_ = std::make_unique<Parts>(sink_, track_, segmentFile);
  Segment segment(segmentFile, track_);
  checkLike(parts_->example, segment);
  parts_->frames += output::append(segment, parts_->frames, parts_->film);
}

void FilmStream::finish() {
  POINSOT_EXPECT(parts_);
  parts_->film.finish();
}

FilmState filmState(const path& film, const std::string& origin) try {
  const auto container = filmContainer(film);
  return container ? sealState(film, fileFormat(*container), origin) : FilmState::kOther;
} catch (const Error&) {
  return FilmState::kOther;
}

bool isWholeFilm(const path& film) try {
  const auto container = filmContainer(film);
  const std::string origin = container ? originOf(film, *container) : "";
  return !origin.empty() && filmState(film, origin) == FilmState::kWhole;
} catch (const Error&) {
  return false;
}

bool isOwnFilm(const path& file) {
  const auto container = filmContainer(file);
  const auto isMark = [](std::string_view text) { return text.starts_with("poinsot "); };
  if (!container) return false;
  try {
    if (isMadeWhole(*container)) {
      if (std::ranges::any_of(animationTexts(file), isMark)) return true;
    } else {
      const TrackReader film(file, fileFormat(*container));
      if (film.namesOtherWriter()) return false;
      if (isMark(film.mark())) return true;
    }
  } catch (const Error&) {  // too damaged to read its texts
  }
  return bearsSeal(file);
}

}  // namespace poinsot::output
