// SPDX-License-Identifier: Apache-2.0
#include "output/ffmpeg_encoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "output/h264_stream.h"

namespace poinsot::output {
namespace {

// Most frames from one key frame to the next. A player that seeks has to decode all of them. Segments are shorter
// and have one key frame each.
constexpr int kMostFramesToKey = 250;
constexpr double kWorstFactor = 51;

struct EncoderFacts {
  const char* name;
  const char* segments;  ///< name of the encoder of the film's segments
  AVPixelFormat (*pixels)(const FilmFormat& format);
  void (*set)(const FilmFormat& format, AVCodecContext& context, AvOptions& options);
};

AVPixelFormat opaquePixels(const FilmFormat& format) {
  return format.chroma == Chroma::k444 ? AV_PIX_FMT_YUV444P : AV_PIX_FMT_YUV420P;
}

const char* wordFor(Effort effort, const std::array<const char*, 3>& words) {
  return words[static_cast<std::size_t>(effort)];
}

/// Converts x264's rate factor for use without macroblock trees: adds 3, so that the error stays the same.
/// Measured on ten scenes of the gallery (720p, medium, crf 12 to 28): the mean is 3.1 by PSNR and 3.0 by SSIM.
/// Single scenes have from 0.9, with almost no motion, to 4.8.
/// @param more  further amount to add
double factorWithoutTrees(double crf, double more = 0) {
  constexpr double kTrees = 3;
  return crf > 0 ? std::min(kWorstFactor, crf + kTrees + more) : 0;
}

/// Converts x264's rate factor (without macroblock trees) to another encoder's scale, so that the error stays the
/// same: offset + slope * factor. Measured on the racket's film (720p, PSNR, factors 12 to 28); the
/// straight line is off by at most 1 in the rate factor.
std::string rateFactor(double factor, double offset, double slope) {
  return fmt::format("{}", std::clamp(std::lround(offset + slope * factor), 1L, 63L));
}

/// Options that give key frames more bits and B-frames fewer bits. They replace macroblock trees: a segment's key
/// frame contains everything that does not move, and most B-frames are not used to predict other frames. At the
/// same error, x264's films become a tenth smaller and x265's a twentieth, in no more time
/// (bench/journal/2026-11.md).
constexpr const char* kFrameKinds = ":ipratio=3:pbratio=1.5";

/// Options for effort medium, in addition to x264's preset "medium". The preset decides by trial encoding, which
/// suits camera films. These options omit trials, search motion more widely and keep chroma equally fine. Eleven
/// films then took two thirds of the time, for the same size at the same error. With a single reference frame,
/// they took an eighth less time again, for 2.5 % more size (bench/journal/2026-11.md).
constexpr const char* kMediumAnalysis = ":subme=2:me=umh:ref=1:b-adapt=0:chroma-qp-offset=-2";

void setX264(const FilmFormat& format, AVCodecContext&, AvOptions& options) {
  options.set("preset", wordFor(format.effort, {"veryfast", "medium", "slower"}));
  const bool fine = format.crf == 0 || format.chroma == Chroma::k444;  // x264's profile High has no lossless mode
  options.set("profile", fine ? "high444" : "high");
  options.set("crf", fmt::format("{}", factorWithoutTrees(format.crf, 1)));  // +1: key frames have less error
  // These films have no cuts or fades. Skipping the detection of both saves 8 % of the time and costs 0.1 % of the
  // size.
  options.set("x264-params",
              fmt::format("threads=1:lookahead-threads=1:cpu-independent=1:mbtree=0:scenecut=0:weightp=0:"
                          "open-gop=0:bframes=3:b-pyramid=normal:aq-strength=0.8:keyint={}{}{}",
                          kMostFramesToKey, kFrameKinds, format.effort == Effort::kMedium ? kMediumAnalysis : ""));
}

void setX265(const FilmFormat& format, AVCodecContext& context, AvOptions& options) {
  context.codec_tag = MKTAG('h', 'v', 'c', '1');  // the tag that QuickTime and Keynote open
  options.set("preset", wordFor(format.effort, {"veryfast", "medium", "slow"}));
  if (format.crf > 0) options.set("crf", fmt::format("{}", factorWithoutTrees(format.crf, 2)));
  options.set(
      "x265-params",
      fmt::format("log-level=none:pools=none:frame-threads=1:wpp=0:cutree=0:open-gop=0:bframes=3:b-pyramid=1:"
                  "info=0:keyint={}{}{}",
                  kMostFramesToKey, kFrameKinds, format.crf > 0 ? "" : ":lossless=1"));
}

AVPixelFormat vp9Pixels(const FilmFormat& format) {
  return format.transparent ? AV_PIX_FMT_YUVA420P : opaquePixels(format);
}

void setVp9(const FilmFormat& format, AVCodecContext& context, AvOptions& options) {
  context.gop_size = kMostFramesToKey;
  context.bit_rate = 0;  // constant quality, without a target bit rate
  options.set("deadline", "good");
  options.set("cpu-used", wordFor(format.effort, {"5", "3", "1"}));
  options.set("row-mt", "0");
  if (format.transparent) options.set("auto-alt-ref", "0");  // not possible with alpha in libvpx
  if (format.crf == 0) return options.set("lossless", "1");
  options.set("crf", rateFactor(factorWithoutTrees(format.crf), -18, 2.1));
}

void setAv1(const FilmFormat& format, AVCodecContext& context, AvOptions& options) {
  setenv("SVT_LOG", "0", 1);  // otherwise SVT-AV1 writes to stderr
  context.gop_size = kMostFramesToKey;
  options.set("preset", wordFor(format.effort, {"10", "8", "5"}));
  options.set("crf", rateFactor(factorWithoutTrees(format.crf), -18.5, 2.2));
  options.set("svtav1-params", "lp=1");
}

AVPixelFormat proResPixels(const FilmFormat& format) {
  return format.transparent ? AV_PIX_FMT_YUVA444P10 : AV_PIX_FMT_YUV444P10;
}

void setProRes(const FilmFormat& format, AVCodecContext&, AvOptions& options) {
  options.set("profile", "4444");
  options.set("vendor", "apl0");  // some editors look for this vendor
  options.set("alpha_bits", format.transparent ? "16" : "0");
}

AVPixelFormat losslessPixels(const FilmFormat& format) {
  return format.transparent ? AV_PIX_FMT_BGRA : AV_PIX_FMT_BGR0;
}

void setLossless(const FilmFormat&, AVCodecContext& context, AvOptions& options) {
  context.gop_size = 1;
  context.level = 3;
  options.set("slicecrc", "1");
}

const EncoderFacts& factsOf(FilmCodec codec) {
  static constexpr std::array<EncoderFacts, 7> kEncoders{{{"libx264", "libx264", opaquePixels, setX264},
                                                          {"libx265", "libx265", opaquePixels, setX265},
                                                          {"prores_ks", "prores_ks", proResPixels, setProRes},
                                                          {"libvpx-vp9", "libvpx-vp9", vp9Pixels, setVp9},
                                                          {"libsvtav1", "libsvtav1", opaquePixels, setAv1},
                                                          {"gif", "ffv1", losslessPixels, setLossless},
                                                          {"apng", "ffv1", losslessPixels, setLossless}}};
  return kEncoders[static_cast<std::size_t>(codec)];
}

/// Declares the colour space of output/yuv.h. Segments in FFV1 are RGB, which needs no declaration.
void describeColor(AVCodecContext& context) {
  if (context.codec_id == AV_CODEC_ID_FFV1) return;
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_range = AVCOL_RANGE_MPEG;
  if (context.pix_fmt == AV_PIX_FMT_YUV420P || context.pix_fmt == AV_PIX_FMT_YUVA420P)
    context.chroma_sample_location = AVCHROMA_LOC_LEFT;
}

void open(AVCodecContext& context, const FilmFormat& format) {
  context.flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_CLOSED_GOP;
  AvOptions options;
  factsOf(format.codec).set(format, context, options);
  openEncoder(context, options);
  // libavcodec does not report x265's delay. With the settings above, x265 has the delay of x264.
  if (context.codec_id == AV_CODEC_ID_H264 && context.has_b_frames != reorderDelay(context.codec_id))
    throw core::encodeError(
        fmt::format("{}: the encoder delays output by {} frames to reorder them, but poinsot needs a delay of {}",
                    context.codec->name, context.has_b_frames, reorderDelay(context.codec_id)));
  if (context.codec_id == AV_CODEC_ID_H264)
    context.extradata_size =
        static_cast<int>(removeEncoderNote({context.extradata, static_cast<std::size_t>(context.extradata_size)}));
}

CodecContextPtr opened(image::PixelSize size, const core::Rational& fps, const FilmFormat& format) {
  checkFormat(format, size, fps);
  const AVCodec* codec = ffmpeg().avcodec_find_encoder_by_name(factsOf(format.codec).segments);
  auto context = checkAlloc(CodecContextPtr(ffmpeg().avcodec_alloc_context3(codec)));
  describePictures(*context, size, fps);
  context->sample_aspect_ratio = {1, 1};
  context->pix_fmt = factsOf(format.codec).pixels(format);
  describeColor(*context);
  open(*context, format);
  return context;
}

}  // namespace

std::int64_t reorderDelay(AVCodecID codec) {
  return codec == AV_CODEC_ID_H264 || codec == AV_CODEC_ID_HEVC ? 2 : 0;
}

const char* encoderName(FilmCodec codec) { return factsOf(codec).name; }

const char* missingEncoder(FilmCodec codec) {
  for (const char* name : {factsOf(codec).name, factsOf(codec).segments})
    if (ffmpeg().avcodec_find_encoder_by_name(name) == nullptr) return name;
  return nullptr;
}

void describePictures(AVCodecContext& context, image::PixelSize size, const core::Rational& fps) {
  context.width = size.width;
  context.height = size.height;
  context.framerate = {static_cast<int>(fps.num), static_cast<int>(fps.den)};
  context.time_base = av_inv_q(context.framerate);
}

void openEncoder(AVCodecContext& context, AvOptions& options) {
  context.thread_count = 1;
  context.flags |= AV_CODEC_FLAG_BITEXACT;
  captureAvLog();
  checkAv(ffmpeg().avcodec_open2(&context, context.codec, options.address()),
          fmt::format("starting {}", context.codec->name));
  options.expectAllTaken();
}

FrameEncoder::FrameEncoder(CodecContextPtr opened)
    : context_(std::move(opened)),
      frame_(checkAlloc(FramePtr(ffmpeg().av_frame_alloc()))),
      packet_(checkAlloc(PacketPtr(ffmpeg().av_packet_alloc()))) {
  frame_->width = context_->width;
  frame_->height = context_->height;
  frame_->format = context_->pix_fmt;
  frame_->color_primaries = context_->color_primaries;  // ProRes reads the colour space from each frame
  frame_->color_trc = context_->color_trc;
  frame_->colorspace = context_->colorspace;
  frame_->color_range = context_->color_range;
  checkAv(ffmpeg().av_frame_get_buffer(frame_.get(), 0), "allocating a frame");
}

AVFrame& FrameEncoder::frame() {
  checkAv(ffmpeg().av_frame_make_writable(frame_.get()), "allocating a frame");
  return *frame_;
}

void FrameEncoder::encode(const PacketSink& sink) {
  frame_->pts = frames_++;
  checkAv(ffmpeg().avcodec_send_frame(context_.get(), frame_.get()), "encoding a frame");
  receive(sink);
}

void FrameEncoder::drain(const PacketSink& sink) {
  checkAv(ffmpeg().avcodec_send_frame(context_.get(), nullptr), "ending the stream");
  receive(sink);
}

void FrameEncoder::receive(const PacketSink& sink) {
  for (;;) {
    const int code = ffmpeg().avcodec_receive_packet(context_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    checkAv(code, "encoding a frame");
    sink(*packet_);
    ffmpeg().av_packet_unref(packet_.get());
  }
}

FilmEncoder::FilmEncoder(image::PixelSize size, const core::Rational& fps, const FilmFormat& format)
    : encoder_(opened(size, fps, format)) {}

FilmEncoder::PacketSink FilmEncoder::withoutNote(const PacketSink& sink) {
  if (context().codec_id != AV_CODEC_ID_H264) return sink;
  return [&](AVPacket& packet) {
    takeOutNote(packet);
    sink(packet);
  };
}

void FilmEncoder::takeOutNote(AVPacket& packet) {
  checkAv(ffmpeg().av_packet_make_writable(&packet), "copying a packet");
  const auto kept = removeEncoderNote({packet.data, static_cast<std::size_t>(packet.size)}, &note_);
  ffmpeg().av_shrink_packet(&packet, static_cast<int>(kept));
}

}  // namespace poinsot::output
