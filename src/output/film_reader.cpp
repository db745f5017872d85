// SPDX-License-Identifier: Apache-2.0
#include "output/film_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.h"
#include "image/png_file.h"
#include "output/ffmpeg_handles.h"
#include "output/film_format.h"

namespace poinsot::output {
namespace {

/// Returns the duration of a frame. FFmpeg 6 renamed the field.
template <class Frame>
std::int64_t ticksOf(const Frame& frame) {
  if constexpr (requires { frame.duration; })
    return frame.duration;
  else
    return frame.pkt_duration;
}

using core::ErrorKind;

struct ScalerDeleter {
  void operator()(SwsContext* scaler) const { ffmpeg().sws_freeContext(scaler); }
};
using ScalerPtr = std::unique_ptr<SwsContext, ScalerDeleter>;

/// Demuxers for files that contain all of their data. Playlists are not allowed, because they make libavformat
/// open other files.
constexpr const char* kDemuxers = "mov,mp4,m4a,3gp,3g2,mj2,matroska,webm,avi,gif,apng";

void checkSize(image::PixelSize size, const std::string& name) {
  const auto most = static_cast<int>(image::kLargestPngSide);
  const std::int64_t pixels = std::int64_t{size.width} * size.height;
  if (size.width > 0 && size.height > 0 && size.width <= most && size.height <= most && pixels <= kMostFilmPixels)
    return;
  throw core::limitError(
      fmt::format("{}: the pictures are {}x{} pixels; at most {} per side and {} million pixels are read", name,
                  size.width, size.height, most, kMostFilmPixels >> 20));
}

/// Reads the properties of the streams. libavformat decodes pictures for this, so the limit on their size is set
/// for each stream.
void findStreamFacts(AVFormatContext& format, std::int64_t mostPixels, const std::string& name) {
  std::vector<AvOptions> options(format.nb_streams);
  std::vector<AVDictionary*> entries;
  for (AvOptions& one : options) {
    one.set("max_pixels", fmt::format("{}", mostPixels));
    entries.push_back(std::exchange(*one.address(), nullptr));
  }
  const int code = ffmpeg().avformat_find_stream_info(&format, entries.data());
  for (std::size_t i = 0; i < entries.size(); ++i) *options[i].address() = entries[i];  // `options` frees them
  checkAv(code, name, ErrorKind::kIo);
}

FormatInputPtr opened(const std::filesystem::path& film, const std::string& name) {
  expectRegularFile(film);
  captureAvLog();
  AvOptions options;
  options.set("format_whitelist", kDemuxers);
  options.set("protocol_whitelist", "file");
  AVFormatContext* context = nullptr;
  // Without a format, libavformat takes a .png for part of an image sequence, which is not an allowed demuxer.
  const AVInputFormat* known = image::isAnimatedPng(film) ? ffmpeg().av_find_input_format("apng") : nullptr;
  checkAv(ffmpeg().avformat_open_input(&context, fileUrl(film).c_str(), known, options.address()), name,
          ErrorKind::kIo);
  return FormatInputPtr(context);
}

int videoStreamOf(AVFormatContext& format, const std::string& name) {
  return checkAv(ffmpeg().av_find_best_stream(&format, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0), name,
                 ErrorKind::kIo);
}

/// Returns the decoder of a stream. VP9 with alpha needs libvpx, because libavcodec's own decoder drops alpha.
const AVCodec* decoderOf(const AVStream& stream) {
  const bool alpha = ffmpeg().av_dict_get(stream.metadata, "alpha_mode", nullptr, 0) != nullptr;
  if (alpha && stream.codecpar->codec_id == AV_CODEC_ID_VP9)
    if (const AVCodec* codec = ffmpeg().avcodec_find_decoder_by_name("libvpx-vp9")) return codec;
  return ffmpeg().avcodec_find_decoder(stream.codecpar->codec_id);
}

CodecContextPtr decoder(const AVStream& stream, std::int64_t mostPixels, const std::string& name) {
  const AVCodec* codec = decoderOf(stream);
  if (codec == nullptr)
    throw core::ioError(fmt::format("{}: this FFmpeg has no decoder for {}", name,
                                    ffmpeg().avcodec_get_name(stream.codecpar->codec_id)));
  CodecContextPtr context(checkAlloc(ffmpeg().avcodec_alloc_context3(codec)));
  checkAv(ffmpeg().avcodec_parameters_to_context(context.get(), stream.codecpar), name, ErrorKind::kIo);
  context->thread_count = 1;
  context->max_pixels = mostPixels;
  context->err_recognition = AV_EF_EXPLODE;
  checkAv(ffmpeg().avcodec_open2(context.get(), codec, nullptr), name, ErrorKind::kIo);
  return context;
}

AVPixelFormat rgbFormat(AVPixelFormat format, const std::string& name) {
  const AVPixFmtDescriptor* facts = ffmpeg().av_pix_fmt_desc_get(format);
  if (facts == nullptr) throw core::ioError(name + ": unknown pixel format");
  // Formats with a palette count as transparent, because a palette may contain transparent colours.
  const bool alpha = (facts->flags & (AV_PIX_FMT_FLAG_ALPHA | AV_PIX_FMT_FLAG_PAL)) != 0;
  if (facts->comp[0].depth > 8) return alpha ? AV_PIX_FMT_RGBA64 : AV_PIX_FMT_RGB48;
  return alpha ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24;
}

bool isDeepRgb(AVPixelFormat rgb) { return rgb == AV_PIX_FMT_RGB48 || rgb == AV_PIX_FMT_RGBA64; }

/// Returns the largest number of pictures that a decoder stores: references, pictures that wait to be shown, and
/// the current picture. VP9 and AV1 have 8 reference slots, HEVC has 16. For H.264, the number is known after one
/// decoded picture.
int heldPictures(const AVCodecContext& codec) {
  const AVCodecDescriptor* facts = ffmpeg().avcodec_descriptor_get(codec.codec_id);
  const bool alone = (facts != nullptr && (facts->props & AV_CODEC_PROP_INTRA_ONLY) != 0) ||
                     codec.codec_id == AV_CODEC_ID_GIF || codec.codec_id == AV_CODEC_ID_APNG;
  if (alone) return 3;  // including the previous picture of a GIF or an APNG
  if (codec.codec_id == AV_CODEC_ID_H264) return codec.refs + codec.has_b_frames + 2;
  if (codec.codec_id == AV_CODEC_ID_VP9 || codec.codec_id == AV_CODEC_ID_AV1) return 8 + 3;
  return 16 + 1;
}

int channelsOf(AVPixelFormat rgb) { return rgb == AV_PIX_FMT_RGBA || rgb == AV_PIX_FMT_RGBA64 ? 4 : 3; }

/// Returns the colour matrix that the film declares. If it declares none, returns the matrix that players assume
/// for its size.
const int* coefficientsOf(const AVFrame& frame) {
  constexpr int kHighDefinition = 720;
  const bool says = frame.colorspace != AVCOL_SPC_UNSPECIFIED && frame.colorspace != AVCOL_SPC_RGB;
  if (says) return ffmpeg().sws_getCoefficients(frame.colorspace);
  return ffmpeg().sws_getCoefficients(frame.height >= kHighDefinition ? SWS_CS_ITU709 : SWS_CS_ITU601);
}

ScalerPtr scaler(const AVFrame& frame, AVPixelFormat rgb, const std::string& name) {
  const auto format = static_cast<AVPixelFormat>(frame.format);
  constexpr int kExact = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP | SWS_BITEXACT;
  ScalerPtr made(ffmpeg().sws_getContext(frame.width, frame.height, format, frame.width, frame.height, rgb, kExact,
                                         nullptr, nullptr, nullptr));
  constexpr int kOne = 1 << 16;
  const int* matrix = coefficientsOf(frame);
  if (!made ||
      ffmpeg().sws_setColorspaceDetails(made.get(), matrix, frame.color_range == AVCOL_RANGE_JPEG ? 1 : 0,
                                        ffmpeg().sws_getCoefficients(SWS_CS_DEFAULT), 1, 0, kOne, kOne) < 0)
    throw core::ioError(name + ": this FFmpeg cannot convert its pictures to RGB");
  return made;
}

template <typename Sample>
image::AnyImage imageOf(const AVFrame& rgb, int channels) {
  image::BasicImage<Sample> picture({rgb.width, rgb.height}, channels);
  for (int y = 0; y < rgb.height; ++y)
    std::memcpy(picture.at(0, y), rgb.data[0] + std::ptrdiff_t{y} * rgb.linesize[0], picture.rowBytes());
  return picture;
}

/// Allocates a frame whose rows libav has padded, because libav may write past the end of a row.
FramePtr rgbFrame(image::PixelSize size, AVPixelFormat rgb, const std::string& name) {
  FramePtr frame(checkAlloc(ffmpeg().av_frame_alloc()));
  frame->width = size.width;
  frame->height = size.height;
  frame->format = rgb;
  checkAv(ffmpeg().av_frame_get_buffer(frame.get(), 0), name, ErrorKind::kIo);
  return frame;
}

}  // namespace

struct FilmReader::Parts {
  Parts(const std::filesystem::path& film, std::int64_t mostPixels)
      : name(core::printable(film.native())), format(opened(film, name)) {
    findStreamFacts(*format, mostPixels, name);
    stream = videoStreamOf(*format, name);
    codec = decoder(track(), mostPixels, name);
    size = {codec->width, codec->height};
    checkSize(size, name);
    waiting = decode();
  }

  const AVStream& track() const { return *format->streams[stream]; }
  AVPixelFormat rgb() const { return rgbFormat(codec->pix_fmt, name); }

  /// Sends the next packet of the video track to the decoder. After the last packet, signals the end of the film.
  void feed() {
    for (;;) {
      const int code = ffmpeg().av_read_frame(format.get(), packet.get());
      if (code == AVERROR_EOF) {
        checkAv(ffmpeg().avcodec_send_packet(codec.get(), nullptr), name, ErrorKind::kIo);
        return;
      }
      checkAv(code, name, ErrorKind::kIo);
      const bool ours = packet->stream_index == stream;
      if ((packet->flags & AV_PKT_FLAG_CORRUPT) != 0) throw core::ioError(name + ": ends too early");
      const int sent = ours ? ffmpeg().avcodec_send_packet(codec.get(), packet.get()) : 0;
      ffmpeg().av_packet_unref(packet.get());
      checkAv(sent, name, ErrorKind::kIo);
      if (ours) return;
    }
  }

  bool advance() { return std::exchange(waiting, false) || decode(); }

  bool decode() {
    for (;;) {
      const int code = ffmpeg().avcodec_receive_frame(codec.get(), frame.get());
      if (code == AVERROR_EOF) return false;
      if (code != AVERROR(EAGAIN)) return checkAv(code, name, ErrorKind::kIo) >= 0;
      feed();
    }
  }

  double seconds(std::int64_t ticks) const {
    const AVRational unit = track().time_base;
    return static_cast<double>(ticks) * unit.num / unit.den;
  }

  /// Returns the picture's duration; 0 for Matroska and AVI. These store no durations, so FFmpeg would return a
  /// guess.
  double duration_s() const {
    const std::string_view container = format->iformat->name;
    const bool says = container.find("matroska") == std::string_view::npos && container != "avi";
    return says ? seconds(ticksOf(*frame)) : 0;
  }

  ShownPicture shown() {
    const std::int64_t start = frame->best_effort_timestamp;
    return {picture(), start == AV_NOPTS_VALUE ? std::nan("") : seconds(start), duration_s()};
  }

  image::AnyImage picture() {
    if (image::PixelSize{frame->width, frame->height} != size)
      throw core::ioError(name + ": its pictures differ in size");
    const AVPixelFormat rgb = rgbFormat(static_cast<AVPixelFormat>(frame->format), name);
    const FramePtr out = rgbFrame(size, rgb, name);
    const int rows = ffmpeg().sws_scale(scaler(*frame, rgb, name).get(), frame->data, frame->linesize, 0,
                                        frame->height, out->data, out->linesize);
    if (checkAv(rows, name, ErrorKind::kIo) != frame->height) throw core::ioError(name + ": a picture lacks rows");
    return isDeepRgb(rgb) ? imageOf<std::uint16_t>(*out, channelsOf(rgb))
                          : imageOf<std::uint8_t>(*out, channelsOf(rgb));
  }

  std::string name;
  FormatInputPtr format;
  int stream = 0;
  CodecContextPtr codec;
  image::PixelSize size;
  PacketPtr packet{checkAlloc(ffmpeg().av_packet_alloc())};
  FramePtr frame{checkAlloc(ffmpeg().av_frame_alloc())};
  bool waiting = false;  ///< whether `frame` is the first picture, not yet returned
};

bool isFilmName(const std::filesystem::path& file) {
  const std::string extension = core::lowered(file.extension().native());
  return filmContainer("film" + extension) || extension == ".mkv" || extension == ".avi" || extension == ".m4v";
}

bool isPictureOrFilmName(const std::filesystem::path& file) { return image::isPngName(file) || isFilmName(file); }

bool isFilm(const std::filesystem::path& file) { return isFilmName(file) || image::isAnimatedPng(file); }

image::PixelSize FilmReader::declaredSize(const std::filesystem::path& film) {
  const std::string name = core::printable(film.native());
  const FormatInputPtr format = opened(film, name);
  const AVCodecParameters& parameters = *format->streams[videoStreamOf(*format, name)]->codecpar;
  return {parameters.width, parameters.height};
}

FilmReader::FilmReader(const std::filesystem::path& film, std::int64_t mostPixels)
    : parts_(std::make_unique<Parts>(film, std::min(mostPixels, kMostFilmPixels))) {}

FilmReader::~FilmReader() = default;

image::PixelSize FilmReader::size() const { return parts_->size; }

bool FilmReader::isTransparent() const { return channelsOf(parts_->rgb()) == 4; }

bool FilmReader::isDeep() const { return isDeepRgb(parts_->rgb()); }

// Decoders store motion vectors in addition to each picture. Measured in tests/faults/film_memory_test.cpp.
double FilmReader::memory_bytes() const {
  constexpr double kMotion_bytes = 0.6;
  const double pixels = 1.0 * size().width * size().height;
  const auto* facts = ffmpeg().av_pix_fmt_desc_get(parts_->codec->pix_fmt);
  const double pixel_bytes = facts == nullptr ? 8 : ffmpeg().av_get_padded_bits_per_pixel(facts) / 8.0;
  return heldPictures(*parts_->codec) * (pixel_bytes + kMotion_bytes) * pixels;
}

core::Rational FilmReader::fps() const {
  const AVRational rate =
      ffmpeg().av_guess_frame_rate(parts_->format.get(), parts_->format->streams[parts_->stream], nullptr);
  return rate.num > 0 && rate.den > 0 ? core::Rational{rate.num, rate.den} : core::Rational{0, 1};
}

double FilmReader::timeStep_s() const { return parts_->seconds(1); }

std::optional<ShownPicture> FilmReader::next() {
  if (!parts_->advance()) return std::nullopt;
  return parts_->shown();
}

}  // namespace poinsot::output
