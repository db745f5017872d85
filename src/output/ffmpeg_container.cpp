// SPDX-License-Identifier: Apache-2.0
#include "output/ffmpeg_container.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>

#include "core/expect.h"
#include "core/text.h"
#include "core/version.h"
#include "output/animation_text.h"
#include "output/ffmpeg_encoder.h"
#include "output/film_seal.h"

namespace poinsot::output {
namespace {

using core::ErrorKind;

#if LIBAVFORMAT_VERSION_MAJOR >= 61
using WrittenByte = const std::uint8_t;
#else
using WrittenByte = std::uint8_t;
#endif

int descriptorOf(void* target) { return static_cast<ByteTarget*>(target)->descriptor; }

int writeBytes(void* target, WrittenByte* bytes, int size) {
  const int code = static_cast<ByteTarget*>(target)->sink({bytes, static_cast<std::size_t>(size)});
  return code == 0 ? size : AVERROR(code);
}

std::int64_t seekBytes(void* target, std::int64_t offset, int whence) {
  if ((whence & AVSEEK_SIZE) != 0) {
    struct stat status {};
    return ::fstat(descriptorOf(target), &status) < 0 ? AVERROR(errno) : status.st_size;
  }
  const off_t at = ::lseek(descriptorOf(target), offset, whence & ~AVSEEK_FORCE);
  return at < 0 ? AVERROR(errno) : at;
}

IoPtr openIo(ByteTarget& target) {
  constexpr int kBuffer = 256 << 10;
  auto* buffer = static_cast<unsigned char*>(ffmpeg().av_malloc(kBuffer));
  if (buffer == nullptr) throw std::bad_alloc();
  auto* const seek = target.descriptor < 0 ? nullptr : seekBytes;
  AVIOContext* io = ffmpeg().avio_alloc_context(buffer, kBuffer, 1, &target, nullptr, writeBytes, seek);
  if (io == nullptr) ffmpeg().av_free(buffer);
  return checkAlloc(IoPtr(io));
}

struct FormatFacts {
  const char *muxer, *demuxer;
  /// Metadata keys for the mark of this program, to write and to read it.
  const char *markKey, *readMarkKey;
  const char *wordsKey = "description", *originKey = "comment";
};

// In a .mov, libavformat writes the key "comment" both as comment and as description, and ignores "description". A
// .mov therefore stores the film's description as "comment", its origin as "model", and the mark of this program
// as "make".
const FormatFacts& factsOf(FileFormat format) {
  static constexpr std::array<FormatFacts, 6> kFacts{{{"mp4", "mp4", "encoding_tool", "encoder"},
                                                      {"mov", "mov", "make", "make", "comment", "model"},
                                                      {"webm", "matroska", "encoded_by", "encoded_by"},
                                                      {"gif", "gif", "encoded_by", "encoded_by"},
                                                      {"apng", "apng", "encoded_by", "encoded_by"},
                                                      {"matroska", "matroska", "encoded_by", "encoded_by"}}};
  return kFacts[static_cast<std::size_t>(format)];
}

bool isOfQuickTime(FileFormat format) { return format == FileFormat::kMp4 || format == FileFormat::kMov; }

FormatOutputPtr allocateFormat(const char* muxer) {
  captureAvLog();
  AVFormatContext* format = nullptr;
  checkAv(ffmpeg().avformat_alloc_output_context2(&format, nullptr, muxer, nullptr),
          fmt::format("opening the writer of {}", muxer), ErrorKind::kEncode);
  return FormatOutputPtr(format);
}

void setText(AVDictionary** texts, const char* key, const std::string& value) {
  checkAv(ffmpeg().av_dict_set(texts, key, value.c_str(), 0), "setting a text");
}

/// Sets the film's metadata. The flag "bitexact" keeps libav from adding its own name and the time.
void describe(AVFormatContext& context, FileFormat format, const FilmTexts& texts) {
  context.flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_FLUSH_PACKETS;
  const FormatFacts& facts = factsOf(format);
  setText(&context.metadata, facts.markKey, ownMark());
  if (!texts.title.empty()) setText(&context.metadata, "title", texts.title);
  if (!texts.description.empty()) setText(&context.metadata, facts.wordsKey, texts.description);
  if (!texts.origin.empty())
    setText(&context.metadata, facts.originKey, sealText(texts.origin) + "; " + texts.renderer);
}

/// Returns the texts of an animation. The origin is a separate text, because the text with the origin must end
/// with the digest.
std::vector<std::string> textsOfAnimation(const FilmTexts& texts) {
  std::vector<std::string> all{ownMark()};
  for (const std::string& line : {texts.renderer, texts.title, texts.description})
    if (!line.empty()) all.front() += "\n" + line;
  if (!texts.origin.empty()) all.push_back(sealText(texts.origin));
  return all;
}

void addTrack(AVFormatContext& format, const AVCodecParameters& parameters, const core::Rational& fps) {
  AVStream* stream = checkAlloc(ffmpeg().avformat_new_stream(&format, nullptr));
  checkAv(ffmpeg().avcodec_parameters_copy(stream->codecpar, &parameters), "describing the track");
  // The muxer chooses the codec tag, except for HEVC and ProRes: these have several tags, and the encoder has
  // chosen one.
  if (parameters.codec_id != AV_CODEC_ID_HEVC && parameters.codec_id != AV_CODEC_ID_PRORES)
    stream->codecpar->codec_tag = 0;
  stream->codecpar->bit_rate = 0;  // measured by the muxer, not copied from the first segment
  stream->avg_frame_rate = stream->r_frame_rate = {static_cast<int>(fps.num), static_cast<int>(fps.den)};
  stream->time_base = av_inv_q(stream->avg_frame_rate);
  if (parameters.format == AV_PIX_FMT_YUVA420P) setText(&stream->metadata, "alpha_mode", "1");
}

const char* movFlags(Index index) {
  switch (index) {
    case Index::kAtEnd:
      return "+write_colr";
    case Index::kAtStart:
      return "+faststart+write_colr";
    case Index::kInPieces:
      return "+frag_keyframe+delay_moov+default_base_moof+write_colr";
  }
  return "";
}

void setOptions(AvOptions& options, FileFormat format, const core::Rational& fps, Index index) {
  const std::string timescale = isOfQuickTime(format) ? fmt::format("{}", frameClock(fps).timescale) : "";
  switch (format) {
    case FileFormat::kMp4:
    case FileFormat::kMov:
      options.set("movflags", movFlags(index));
      options.set("video_track_timescale", timescale);
      return options.set("movie_timescale", timescale);  // otherwise durations are truncated to milliseconds
    case FileFormat::kGif:
      return options.set("final_delay", fmt::format("{}", std::lround(100 / fps.value())));
    case FileFormat::kApng:
      options.set("plays", "0");  // repeat forever
      return options.set("final_delay", fmt::format("{}/{}", fps.den, fps.num));
    case FileFormat::kWebm:
    case FileFormat::kMatroska:
      if (index == Index::kAtStart) options.set("cues_to_front", "1");
  }
}

}  // namespace

FileFormat fileFormat(FilmContainer container) {
  static constexpr std::array kFormats{FileFormat::kMp4, FileFormat::kMov, FileFormat::kWebm, FileFormat::kGif,
                                       FileFormat::kApng};
  return kFormats[static_cast<std::size_t>(container)];
}

FileFormat segmentFormat(FilmContainer container) {
  return isMadeWhole(container) ? FileFormat::kMatroska : fileFormat(container);
}

FrameClock frameClock(const core::Rational& fps) {
  constexpr std::int64_t kFineEnough = 10000, kLargest = 1'000'000'000;  // the container has 32-bit numbers
  POINSOT_EXPECT(fps.num > 0 && fps.den > 0);
  std::int64_t factor = 1;
  while (fps.num * factor < kFineEnough) factor *= 2;
  if (fps.num * factor > kLargest || fps.den > kLargest / factor)
    throw core::usageError(
        fmt::format("{} frames per second: an MP4 has no exact clock for this rate", core::toString(fps)));
  return {static_cast<int>(fps.num * factor), static_cast<int>(fps.den * factor)};
}

std::string ownMark() { return fmt::format("poinsot {}", core::version()); }

TrackMuxer::TrackMuxer(ByteTarget target, FileFormat format, const AVCodecParameters& parameters,
                       const core::Rational& fps, Index index, const FilmTexts& texts)
    : target_(std::move(target)),
      io_(openIo(target_)),
      format_(allocateFormat(factsOf(format).muxer)),
      frame_s_{static_cast<int>(fps.den), static_cast<int>(fps.num)},
      reorderDelay_(reorderDelay(parameters.codec_id)) {
  POINSOT_EXPECT(index != Index::kAtStart || !target_.file.empty());
  AvOptions options;
  setOptions(options, format, fps, index);
  format_->pb = io_.get();
  format_->url = checkAlloc(ffmpeg().av_strdup(fileUrl(target_.file).c_str()));
  describe(*format_, format, texts);
  addTrack(*format_, parameters, fps);
  check(ffmpeg().avformat_write_header(format_.get(), options.address()), "starting the film");
  options.expectAllTaken();
  if (isOfQuickTime(format)) POINSOT_EXPECT(format_->streams[0]->time_base.den == frameClock(fps).timescale);
}

int TrackMuxer::check(int code, std::string_view doing) const {
  if (code >= 0) return code;
  if (code == AVERROR(EPIPE)) throw core::BrokenPipe();
  return checkAv(code, fmt::format("{}: {}", core::printable(target_.name), doing), ErrorKind::kIo);
}

/// Returns the time of a frame in the track's time unit. The time is exact in MP4, and rounded to a millisecond in
/// Matroska.
std::int64_t TrackMuxer::ticksAt(std::int64_t frame) const {
  return ffmpeg().av_rescale_q(frame, frame_s_, format_->streams[0]->time_base);
}

void TrackMuxer::write(AVPacket& packet, std::int64_t frame) {
  const std::int64_t place = packets_++ - reorderDelay_;
  POINSOT_EXPECT(place <= frame);
  packet.stream_index = 0;
  packet.pts = ticksAt(frame);
  packet.dts = ticksAt(place);
  packet.duration = ticksAt(frame + 1) - packet.pts;
  packet.pos = -1;
  check(ffmpeg().av_write_frame(format_.get(), &packet), "writing");
  check(io_->error, "writing");
}

void TrackMuxer::finish() {
  check(ffmpeg().av_write_trailer(format_.get()), "writing the index");
  ffmpeg().avio_flush(io_.get());
  check(io_->error, "writing");
}

TrackWriter::TrackWriter(const std::filesystem::path& target, FileFormat format,
                         const AVCodecParameters& parameters, const core::Rational& fps, Index index,
                         const FilmTexts& texts, const std::filesystem::path& temporaryFolder)
    : file_(target, temporaryFolder),
      format_(format),
      texts_(texts),
      muxer_({[this](std::span<const std::uint8_t> bytes) { return core::writeAll(file_.descriptor(), bytes); },
              target.native(), file_.descriptor(), file_.temporary()},
             format, parameters, fps, index, texts) {}

core::AtomicFile TrackWriter::finish() {
  muxer_.finish();
  if (isAnimation(format_)) insertTexts(file_, format_, textsOfAnimation(texts_));
  if (!texts_.origin.empty()) seal(file_, format_, texts_.origin);
  return std::move(file_);
}

TrackReader::TrackReader(const std::filesystem::path& path, FileFormat format) : path_(path), kind_(format) {
  expectRegularFile(path);
  captureAvLog();
  AvOptions options;
  options.set("ignore_editlist", "1");
  options.set("protocol_whitelist", "file");
  AVFormatContext* opened = nullptr;
  const std::string doing = core::printable(path.native());
  // On failure, avformat_open_input() frees the context and clears the pointer.
  checkAv(ffmpeg().avformat_open_input(&opened, fileUrl(path).c_str(),
                                       ffmpeg().av_find_input_format(factsOf(format).demuxer), options.address()),
          doing, ErrorKind::kIo);
  format_.reset(opened);
  if (opened->nb_streams != 1 || parameters().codec_type != AVMEDIA_TYPE_VIDEO)
    throw core::ioError(doing + ": is not a film with one video track");
  AVStream& stream = *format_->streams[0];
  if (ffmpeg().av_dict_get(stream.metadata, "alpha_mode", nullptr, 0) != nullptr)
    stream.codecpar->format = AV_PIX_FMT_YUVA420P;
}

std::string TrackReader::mark() const { return tag(factsOf(kind_).readMarkKey); }

bool TrackReader::namesOtherWriter() const {
  const std::string writer = tag("encoder");  // "Lavf" in Matroska files of this program
  return !writer.empty() && writer != "Lavf" && !writer.starts_with("poinsot ");
}

std::string TrackReader::comment() const { return tag(factsOf(kind_).originKey); }

std::string TrackReader::tag(const std::string& name) const {
  const AVDictionaryEntry* entry = ffmpeg().av_dict_get(format_->metadata, name.c_str(), nullptr, 0);
  return entry == nullptr ? "" : entry->value;
}

bool TrackReader::next(AVPacket& packet) {
  ffmpeg().av_packet_unref(&packet);
  const int code = ffmpeg().av_read_frame(format_.get(), &packet);
  if (code == AVERROR_EOF) return false;
  checkAv(code, core::printable(path_.native()), ErrorKind::kIo);
  // libavformat reads a truncated file without an error. Only this flag of the last packet reveals the damage.
  if ((packet.flags & AV_PKT_FLAG_CORRUPT) != 0)
    throw core::ioError(fmt::format("{}: ends too early", core::printable(path_.native())));
  return true;
}

}  // namespace poinsot::output
