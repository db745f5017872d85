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

/// Feeds an encoder frame by frame.
class FrameEncoder {
 public:
  /// Gets each packet in decoding order; pts is the frame's number in the stream, from 0.
  using PacketSink = std::function<void(AVPacket&)>;

  /// @param opened  told of size, pixel format and rate. @throws core::Error(kEncode) for want of memory.
  explicit FrameEncoder(CodecContextPtr opened);

  /// Where the next picture goes: of context()'s size and pixel format.
  AVFrame& frame();
  /// Encodes what was put there.
  void encode(const PacketSink& sink);
  /// After the last frame.
  void drain(const PacketSink& sink);

  const AVCodecContext& context() const { return *context_; }

 private:
  void receive(const PacketSink& sink);

  CodecContextPtr context_;
  FramePtr frame_;
  PacketPtr packet_;
  std::int64_t frames_ = 0;
};

/// Tells an encoder of pictures of this size and rate.
void describePictures(AVCodecContext& context, image::PixelSize size, const core::Rational& fps);

/// Opens an encoder that was told of its pictures: one thread, nothing of this machine in what it writes.
/// @throws core::Error(kEncode) if it will not start, or does not know an option.
void openEncoder(AVCodecContext& context, AvOptions& options);

/// An encoder set so that the same frames give the same bytes with any number of workers, and, of H.264, on every
/// machine: one thread, nothing that depends on the processor, closed groups of pictures, no note about itself in
/// the stream. Macroblock trees are left out, as within segments of 30 frames they would save 3 to 12 % of the
/// size for half as much memory again. For a film that is made whole (isMadeWhole()) it keeps every pixel as it
/// is.
class FilmEncoder {
 public:
  using PacketSink = FrameEncoder::PacketSink;

  /// @throws core::Error as checkFormat(); (kEncode) if the encoder will not start.
  FilmEncoder(image::PixelSize size, const core::Rational& fps, const FilmFormat& format);

  AVFrame& frame() { return encoder_.frame(); }
  void encode(const PacketSink& sink) { encoder_.encode(withoutNote(sink)); }
  void drain(const PacketSink& sink) { encoder_.drain(withoutNote(sink)); }

  const AVCodecContext& context() const { return encoder_.context(); }
  /// "x264 - core 164 r3095 ...", what x264 says of itself; empty before the first packet, and of other encoders.
  const std::string& note() const { return note_; }

 private:
  /// The sink for packets whose note about the encoder is to be kept here.
  PacketSink withoutNote(const PacketSink& sink);
  void takeOutNote(AVPacket& packet);

  FrameEncoder encoder_;
  std::string note_;
};

}  // namespace poinsot::output
