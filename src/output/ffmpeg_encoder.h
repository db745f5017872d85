// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/rational.h"
#include "image/image.h"
#include "output/ffmpeg_handles.h"
#include "output/film_format.h"

namespace poinsot::output {

/// Frames by which the order of a stream runs ahead of the shown order: with x264 and x265 as they are set here it
/// is 2 for every stream, however short (B-frames that others refer to); the others keep the order. Decoding times
/// are (position in the stream) - this.
std::int64_t reorderDelay(AVCodecID codec);

/// libavcodec's name of the encoder: "libx264".
const char* encoderName(FilmCodec codec);
/// Which of the encoders that a film of it takes this libavcodec lacks; null if it has them all. A codec whose
/// films are made whole takes another for the segments.
/// @throws core::Error(kEncode) if there is no FFmpeg at all, as do all below.
const char* missingEncoder(FilmCodec codec);

/// An encoder set so that the same frames give the same bytes with any number of workers, and, of H.264, on every
/// machine: one thread, nothing that depends on the processor, closed groups of pictures, no note about itself in
/// the stream. Macroblock trees are left out, as within segments of 30 frames they would save 3 to 12 % of the
/// size for half as much memory again. For a film that is made whole (isMadeWhole()) it keeps every pixel as it
/// is.
class FilmEncoder {
 public:
  /// Gets each packet in decoding order; pts is the frame's number in the stream, from 0.
  using PacketSink = std::function<void(AVPacket&)>;

  /// @throws core::Error as checkFormat(); (kEncode) if the encoder will not start.
  FilmEncoder(image::PixelSize size, const core::Rational& fps, const FilmFormat& format);

  /// Where the next picture goes: of context()'s size and pixel format.
  AVFrame& frame();
  /// Encodes what was put there.
  void encode(const PacketSink& sink);
  /// After the last frame.
  void drain(const PacketSink& sink);

  const AVCodecContext& context() const { return *context_; }
  /// "x264 - core 164 r3095 ...", what x264 says of itself; empty before the first packet, and of other encoders.
  const std::string& note() const { return note_; }

 private:
  void takeOutNote(AVPacket& packet);
  void receive(const PacketSink& sink);

  CodecContextPtr context_;
  FramePtr frame_;
  PacketPtr packet_;
  std::int64_t frames_ = 0;
  std::string note_;
};

}  // namespace poinsot::output
