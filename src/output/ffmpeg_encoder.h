// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/rational.h"
#include "image/image.h"
#include "output/ffmpeg_handles.h"
#include "output/yuv.h"

namespace poinsot::output {

/// Frames by which the encoder's order runs ahead of the shown order: x264's medium preset has B-frames that
/// others refer to, which makes 2 for every stream, however short. Decoding times are (position in the stream) -
/// this.
inline constexpr std::int64_t kReorderDelay = 2;

/// libx264 set so that the same frames give the same bytes on every machine and with any number of workers: one
/// thread, no macroblock tree (its reciprocals differ between processors), closed groups of pictures, no note
/// about itself in the stream.
class H264Encoder {
 public:
  /// Gets each packet in decoding order; pts is the frame's number in the stream, from 0.
  using PacketSink = std::function<void(AVPacket&)>;

  /// @param crf  constant rate factor, 0 (lossless, a profile that few players know) to 51.
  /// @throws core::Error(kUsage) for odd sizes or crf out of range, core::Error(kEncode) if x264 will not start.
  H264Encoder(image::PixelSize size, const core::Rational& fps, double crf);

  /// Where the next frame goes.
  YuvPlanes planes();
  void encode(const PacketSink& sink);
  /// After the last frame.
  void drain(const PacketSink& sink);

  const AVCodecContext& context() const { return *context_; }
  /// "x264 - core 164 r3095 ...", what x264 says of itself; empty before the first packet.
  const std::string& note() const { return note_; }

 private:
  void receive(const PacketSink& sink);

  CodecContextPtr context_;
  FramePtr frame_;
  PacketPtr packet_;
  std::int64_t frames_ = 0;
  std::string note_;
};

}  // namespace poinsot::output
