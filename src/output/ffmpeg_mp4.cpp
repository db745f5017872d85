// SPDX-License-Identifier: Apache-2.0
#include "output/ffmpeg_mp4.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "core/expect.h"
#include "core/text.h"
#include "core/version.h"
#include "output/ffmpeg_encoder.h"

namespace poinsot::output {
namespace {

using core::Error;
using core::ErrorKind;

#if LIBAVFORMAT_VERSION_MAJOR >= 61
using WrittenByte = const std::uint8_t;
#else
using WrittenByte = std::uint8_t;
#endif

int descriptorOf(void* file) { return static_cast<AtomicFile*>(file)->descriptor(); }

int writeToFile(void* file, WrittenByte* bytes, int size) {
  const int code = writeAll(descriptorOf(file), {bytes, static_cast<std::size_t>(size)});
  return code == 0 ? size : AVERROR(code);
}

std::int64_t seekInFile(void* file, std::int64_t offset, int whence) {
  if ((whence & AVSEEK_SIZE) != 0) {
    struct stat status {};
    return ::fstat(descriptorOf(file), &status) < 0 ? AVERROR(errno) : status.st_size;
  }
  const off_t at = ::lseek(descriptorOf(file), offset, whence & ~AVSEEK_FORCE);
  return at < 0 ? AVERROR(errno) : at;
}

IoPtr openIo(AtomicFile& file) {
  constexpr int kBuffer = 256 << 10;
  auto* buffer = static_cast<unsigned char*>(av_malloc(kBuffer));
  if (buffer == nullptr) throw std::bad_alloc();
  AVIOContext* io = avio_alloc_context(buffer, kBuffer, 1, &file, nullptr, writeToFile, seekInFile);
  if (io == nullptr) av_free(buffer);
  return checkAlloc(IoPtr(io));
}

FormatOutputPtr allocateFormat() {
  captureAvLog();
  AVFormatContext* format = nullptr;
  checkAv(avformat_alloc_output_context2(&format, nullptr, "mp4", nullptr), "opening the MP4 writer",
          ErrorKind::kEncode);
  return FormatOutputPtr(format);
}

/// "file:" keeps libav from reading a protocol into a name such as "a:b.mp4".
std::string fileUrl(const std::filesystem::path& path) { return "file:" + path.native(); }

/// Texts of ours only: with "bitexact" libav adds neither its name nor the time.
void describe(AVFormatContext& format, const std::vector<FilmText>& texts) {
  format.flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_FLUSH_PACKETS;
  checkAv(av_dict_set(&format.metadata, "encoding_tool", ownMark().c_str(), 0), "setting a text");
  for (const FilmText& text : texts)
    checkAv(av_dict_set(&format.metadata, text.key.c_str(), text.value.c_str(), 0), "setting a text");
}

void addTrack(AVFormatContext& format, const AVCodecParameters& parameters, const FrameClock& clock) {
  AVStream* stream = checkAlloc(avformat_new_stream(&format, nullptr));
  checkAv(avcodec_parameters_copy(stream->codecpar, &parameters), "describing the track");
  stream->codecpar->codec_tag = 0;  // the writer's choice, not that of the file the packets come from
  stream->codecpar->bit_rate = 0;   // measured by the writer, not taken over from the first segment
  stream->time_base = {1, clock.timescale};
  stream->avg_frame_rate = stream->r_frame_rate = {clock.timescale, clock.ticks};
}

void checkRegular(const std::filesystem::path& path) {
  struct stat status {};
  const bool found = ::stat(path.c_str(), &status) == 0;
  if (found && S_ISREG(status.st_mode)) return;
  throw Error(ErrorKind::kIo, fmt::format("{}: {}", core::printable(path.native()),
                                          found ? "not a regular file" : "cannot be read"));
}

}  // namespace

FrameClock frameClock(const core::Rational& fps) {
  constexpr std::int64_t kFineEnough = 10000, kLargest = 1'000'000'000;  // the container has 32 bits for each
  POINSOT_EXPECT(fps.num > 0 && fps.den > 0);
  std::int64_t factor = 1;
  while (fps.num * factor < kFineEnough) factor *= 2;
  if (fps.num * factor > kLargest || fps.den > kLargest / factor)
    throw Error(ErrorKind::kUsage,
                fmt::format("{} frames a second: no exact clock in an MP4", core::toString(fps)));
  return {static_cast<int>(fps.num * factor), static_cast<int>(fps.den * factor)};
}

std::string ownMark() { return fmt::format("poinsot {}", core::version()); }

// ---- writing

Mp4Writer::Mp4Writer(const std::filesystem::path& target, const AVCodecParameters& parameters,
                     const FrameClock& clock, Index index, const std::vector<FilmText>& texts,
                     const std::filesystem::path& temporaryFolder)
    : file_(target, temporaryFolder), io_(openIo(file_)), format_(allocateFormat()), clock_(clock) {
  format_->pb = io_.get();
  // To put the index first, libav reads the file again by name.
  format_->url = checkAlloc(av_strdup(fileUrl(file_.temporary()).c_str()));
  describe(*format_, texts);
  addTrack(*format_, parameters, clock);
  AvOptions options;
  options.set("movflags", index == Index::kAtStart ? "+faststart+write_colr" : "+write_colr");
  options.set("video_track_timescale", fmt::format("{}", clock.timescale));
  options.set("movie_timescale", fmt::format("{}", clock.timescale));  // else durations are cut to milliseconds
  check(avformat_write_header(format_.get(), options.address()), "starting the MP4");
  options.expectAllTaken();
  POINSOT_EXPECT(format_->streams[0]->time_base.den == clock.timescale);
}

int Mp4Writer::check(int code, std::string_view doing) const {
  if (code >= 0) return code;
  return checkAv(code, fmt::format("{}: {}", core::printable(file_.target().native()), doing), ErrorKind::kIo);
}

void Mp4Writer::checkIo() const { check(io_->error, "writing"); }

void Mp4Writer::write(AVPacket& packet, std::int64_t frame) {
  const std::int64_t place = packets_++ - kReorderDelay;
  POINSOT_EXPECT(place <= frame);
  packet.stream_index = 0;
  packet.pts = frame * clock_.ticks;
  packet.dts = place * clock_.ticks;
  packet.duration = clock_.ticks;
  packet.pos = -1;
  check(av_write_frame(format_.get(), &packet), "writing");
  checkIo();
}

void Mp4Writer::finish() {
  check(av_write_trailer(format_.get()), "writing the index");
  avio_flush(io_.get());
  checkIo();
  format_.reset();
  io_.reset();
  file_.commit();
}

// ---- reading

Mp4Reader::Mp4Reader(const std::filesystem::path& path) : path_(path) {
  checkRegular(path);
  captureAvLog();
  AvOptions options;
  options.set("ignore_editlist", "1");
  options.set("protocol_whitelist", "file");
  AVFormatContext* format = nullptr;
  const std::string doing = core::printable(path.native());
  // On failure the context is freed and the pointer cleared.
  checkAv(avformat_open_input(&format, fileUrl(path).c_str(), av_find_input_format("mp4"), options.address()),
          doing, ErrorKind::kIo);
  format_.reset(format);
  if (format->nb_streams != 1 || parameters().codec_type != AVMEDIA_TYPE_VIDEO)
    throw Error(ErrorKind::kIo, doing + ": is not a film with one video track");
}

std::string Mp4Reader::text(const char* key) const {
  const AVDictionaryEntry* entry = av_dict_get(format_->metadata, key, nullptr, 0);
  return entry == nullptr ? "" : entry->value;
}

bool Mp4Reader::next(AVPacket& packet) {
  av_packet_unref(&packet);
  const int code = av_read_frame(format_.get(), &packet);
  if (code == AVERROR_EOF) return false;
  checkAv(code, core::printable(path_.native()), ErrorKind::kIo);
  // Cut files are read to their cut as if they ended there; only the mark on the packet tells.
  if ((packet.flags & AV_PKT_FLAG_CORRUPT) != 0)
    throw Error(ErrorKind::kIo, fmt::format("{}: ends too early", core::printable(path_.native())));
  return true;
}

}  // namespace poinsot::output
