// SPDX-License-Identifier: Apache-2.0
#include "output/ffmpeg_encoder.h"

#include <fmt/format.h>

#include "output/h264_stream.h"

namespace poinsot::output {
namespace {

using core::Error;
using core::ErrorKind;

void checkRequest(image::PixelSize size, double crf) {
  if (size.width < 2 || size.height < 2 || size.width % 2 != 0 || size.height % 2 != 0)
    throw Error(ErrorKind::kUsage,
                fmt::format("a film of {}x{} pixels: width and height must be even (chroma has half of each); the "
                            "nearest is {}x{}",
                            size.width, size.height, std::max(2, size.width & ~1), std::max(2, size.height & ~1)));
  if (!(crf >= 0 && crf <= 51))
    throw Error(ErrorKind::kUsage, fmt::format("crf {}: must be from 0 (lossless) to 51", crf));
}

const AVCodec& libx264() {
  const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
  if (codec == nullptr) throw Error(ErrorKind::kEncode, "this libavcodec was built without libx264");
  return *codec;
}

AVRational toAv(const core::Rational& r) { return {static_cast<int>(r.num), static_cast<int>(r.den)}; }

void describePicture(AVCodecContext& context, image::PixelSize size, const core::Rational& fps) {
  context.width = size.width;
  context.height = size.height;
  context.pix_fmt = AV_PIX_FMT_YUV420P;
  context.sample_aspect_ratio = {1, 1};
  context.framerate = toAv(fps);
  context.time_base = av_inv_q(context.framerate);
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_range = AVCOL_RANGE_MPEG;
  context.chroma_sample_location = AVCHROMA_LOC_LEFT;
}

void open(AVCodecContext& context, double crf) {
  context.thread_count = 1;
  context.flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT | AV_CODEC_FLAG_CLOSED_GOP;
  AvOptions options;
  options.set("preset", "medium");
  options.set("profile", crf == 0 ? "high444" : "high");  // x264 has no lossless in High
  options.set("crf", fmt::format("{}", crf));
  // keyint: a seek decodes at most 250 frames; segments are shorter, so each has one key frame unless the scene
  // cuts.
  options.set("x264-params",
              "threads=1:lookahead-threads=1:mbtree=0:open-gop=0:bframes=3:b-pyramid=normal:keyint=250");
  captureAvLog();
  checkAv(avcodec_open2(&context, context.codec, options.address()), "starting the H.264 encoder");
  options.expectAllTaken();
  if (context.has_b_frames != kReorderDelay)
    throw Error(ErrorKind::kEncode,
                fmt::format("x264 reorders by {} frames, not {}", context.has_b_frames, kReorderDelay));
  context.extradata_size =
      static_cast<int>(removeEncoderNote({context.extradata, static_cast<std::size_t>(context.extradata_size)}));
}

}  // namespace

H264Encoder::H264Encoder(image::PixelSize size, const core::Rational& fps, double crf) {
  checkRequest(size, crf);
  context_ = checkAlloc(CodecContextPtr(avcodec_alloc_context3(&libx264())));
  frame_ = checkAlloc(FramePtr(av_frame_alloc()));
  packet_ = checkAlloc(PacketPtr(av_packet_alloc()));
  describePicture(*context_, size, fps);
  open(*context_, crf);
  frame_->width = size.width;
  frame_->height = size.height;
  frame_->format = context_->pix_fmt;
  checkAv(av_frame_get_buffer(frame_.get(), 0), "allocating a frame");
}

YuvPlanes H264Encoder::planes() {
  checkAv(av_frame_make_writable(frame_.get()), "allocating a frame");
  return {frame_->data[0],     frame_->data[1],     frame_->data[2],
          frame_->linesize[0], frame_->linesize[1], frame_->linesize[2]};
}

void H264Encoder::encode(const PacketSink& sink) {
  frame_->pts = frames_++;
  checkAv(avcodec_send_frame(context_.get(), frame_.get()), "encoding a frame");
  receive(sink);
}

void H264Encoder::drain(const PacketSink& sink) {
  checkAv(avcodec_send_frame(context_.get(), nullptr), "ending the stream");
  receive(sink);
}

void H264Encoder::receive(const PacketSink& sink) {
  for (;;) {
    const int code = avcodec_receive_packet(context_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    checkAv(code, "encoding a frame");
    checkAv(av_packet_make_writable(packet_.get()), "copying a packet");
    const auto kept = removeEncoderNote({packet_->data, static_cast<std::size_t>(packet_->size)}, &note_);
    av_shrink_packet(packet_.get(), static_cast<int>(kept));
    sink(*packet_);
    av_packet_unref(packet_.get());
  }
}

}  // namespace poinsot::output
