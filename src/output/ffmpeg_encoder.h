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

/// Returns the number of frames by which decoding order runs ahead of presentation order. With the settings used
/// here, it is 2 for x264 and x265, even for short streams, because B-frames refer to other B-frames. It is 0 for
/// other codecs. A packet's decoding time is its position in the stream minus this number.
std::int64_t reorderDelay(AVCodecID codec);

const char* encoderName(FilmCodec codec);
/// Returns the name of an encoder that this codec needs but this libavcodec does not have; null if none is
/// missing. A GIF and an APNG need a second encoder for their segments.
/// @throws core::Error(kEncode) if FFmpeg cannot be opened; as do all functions below.
const char* missingEncoder(FilmCodec codec);

class FrameEncoder {
 public:
  /// Callback that receives packets in decoding order. A packet's pts is the number of its frame in the stream,
  /// from 0.
  using PacketSink = std::function<void(AVPacket&)>;

  /// @param opened  an open encoder with size, pixel format and frame rate.
  /// @throws core::Error(kEncode) if memory for a frame runs out.
  explicit FrameEncoder(CodecContextPtr opened);

  /// Returns the buffer for the next picture. It has the size and pixel format of context().
  AVFrame& frame();
  void encode(const PacketSink& sink);
  /// Passes the remaining packets to the sink. Call after the last frame.
  void drain(const PacketSink& sink);

  const AVCodecContext& context() const { return *context_; }

 private:
  void receive(const PacketSink& sink);

  CodecContextPtr context_;
  FramePtr frame_;
  PacketPtr packet_;
  std::int64_t frames_ = 0;
};

void describePictures(AVCodecContext& context, image::PixelSize size, const core::Rational& fps);

/// Opens an encoder; call describePictures() before. The encoder uses one thread and writes no data of this
/// machine.
/// @throws core::Error(kEncode) if the encoder does not start or rejects an option.
void openEncoder(AVCodecContext& context, AvOptions& options);

/// Encoder of films and segments; lossless for the segments of a GIF or an APNG (isMadeWhole()). The same frames
/// give the same bytes with any number of workers and, for H.264, on every machine. It therefore uses one thread,
/// nothing that depends on the processor, closed groups of pictures, and no encoder note in the stream. It uses no
/// macroblock trees: in segments of 30 frames they would save 3 to 12 % of the size, but take 1.5 times the
/// memory.
class FilmEncoder {
 public:
  using PacketSink = FrameEncoder::PacketSink;

  /// @throws core::Error as checkFormat(), and core::Error(kEncode) if the encoder does not start.
  FilmEncoder(image::PixelSize size, const core::Rational& fps, const FilmFormat& format);

  AVFrame& frame() { return encoder_.frame(); }
  void encode(const PacketSink& sink) { encoder_.encode(withoutNote(sink)); }
  void drain(const PacketSink& sink) { encoder_.drain(withoutNote(sink)); }

  const AVCodecContext& context() const { return encoder_.context(); }
  /// Returns x264's note about itself, such as "x264 - core 164 r3095 ...". Empty before the first packet, and for
  /// other encoders.
  const std::string& note() const { return note_; }

 private:
  PacketSink withoutNote(const PacketSink& sink);
  void takeOutNote(AVPacket& packet);

  FrameEncoder encoder_;
  std::string note_;
};

}  // namespace poinsot::output
