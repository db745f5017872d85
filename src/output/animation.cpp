// SPDX-License-Identifier: Apache-2.0
#include "output/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "core/text.h"
#include "output/ffmpeg_container.h"
#include "output/ffmpeg_encoder.h"
#include "output/film_frame.h"
#include "output/ordered_dither.h"

namespace poinsot::output {
namespace {

using core::ErrorKind;
using std::filesystem::path;

// The palette is computed from about this many pictures, spread evenly over the film. More pictures take longer
// and give the same palette.
constexpr std::int64_t kPicturesForPalette = 100;

// Largest picture that is decoded, in pixels. OpenGL draws no larger picture here, even if a user raises every
// limit.
constexpr std::int64_t kMostPixels = std::int64_t{16384} * 16384;

using PictureListener = std::function<void(const image::Image&)>;

[[noreturn]] void refuse(const path& segment, std::string_view reason) {
  throw core::ioError(fmt::format("{}: {}", core::printable(segment.native()), reason));
}

CodecContextPtr decoderOf(const AVCodecParameters& parameters) {
  auto decoder = checkAlloc(
      CodecContextPtr(ffmpeg().avcodec_alloc_context3(ffmpeg().avcodec_find_decoder(parameters.codec_id))));
  checkAv(ffmpeg().avcodec_parameters_to_context(decoder.get(), &parameters), "describing the segments");
  decoder->thread_count = 1;
  decoder->max_pixels = kMostPixels;
  checkAv(ffmpeg().avcodec_open2(decoder.get(), nullptr, nullptr), "reading the segments", ErrorKind::kIo);
  return decoder;
}

void readSegment(const path& file, const PictureListener& listen) {
  TrackReader reader(file, FileFormat::kMatroska);
  if (reader.mark() != ownMark()) refuse(file, "is not a segment written by this version of poinsot");
  const auto decoder = decoderOf(reader.parameters());
  const auto packet = checkAlloc(PacketPtr(ffmpeg().av_packet_alloc()));
  const auto frame = checkAlloc(FramePtr(ffmpeg().av_frame_alloc()));
  while (reader.next(*packet)) {
    const std::string doing = core::printable(file.native());
    checkAv(ffmpeg().avcodec_send_packet(decoder.get(), packet.get()), doing, ErrorKind::kIo);
    checkAv(ffmpeg().avcodec_receive_frame(decoder.get(), frame.get()), doing, ErrorKind::kIo);
    if (frame->format != AV_PIX_FMT_BGR0 && frame->format != AV_PIX_FMT_BGRA)
      refuse(file, "has pictures of another kind than this version of poinsot writes");
    listen(pictureOf(*frame));
  }
}

/// Passes all pictures to `listen`. Throws if a picture's size or channel count differs from the first picture's.
void readAll(const std::vector<path>& segments, const PictureListener& listen) {
  std::optional<image::PixelSize> size;
  int channels = 0;
  for (const path& file : segments)
    readSegment(file, [&](const image::Image& picture) {
      if (!size) channels = picture.channels;
      if (size.value_or(picture.size) != picture.size || channels != picture.channels)
        refuse(file, "has pictures of another size or kind than the segments before it");
      size = picture.size;
      listen(picture);
    });
  if (!size) refuse(segments.front(), "has no frames");
}

std::int64_t countPictures(const std::vector<path>& segments) {
  std::int64_t count = 0;
  const auto packet = checkAlloc(PacketPtr(ffmpeg().av_packet_alloc()));
  for (const path& file : segments) {
    TrackReader reader(file, FileFormat::kMatroska);
    while (reader.next(*packet)) ++count;
  }
  return count;
}

std::vector<Rgb> paletteOf(const std::vector<path>& segments, int colors) {
  const std::int64_t step = std::max<std::int64_t>(1, countPictures(segments) / kPicturesForPalette);
  PaletteMaker maker(colors);
  std::int64_t i = 0;
  readAll(segments, [&](const image::Image& picture) {
    if (i++ % step == 0) maker.add(picture);
  });
  return maker.palette();
}

CodecContextPtr opened(const FilmTrack& track, AVPixelFormat pixels, image::PixelSize size) {
  const AVCodec* codec = ffmpeg().avcodec_find_encoder_by_name(encoderName(codecsOf(track.container).front()));
  if (codec == nullptr) throw core::encodeError("this libavcodec was built without this film's encoder");
  auto context = checkAlloc(CodecContextPtr(ffmpeg().avcodec_alloc_context3(codec)));
  describePictures(*context, size, track.fps);
  context->pix_fmt = pixels;
  AvOptions options;
  if (codec->id == AV_CODEC_ID_APNG) options.set("pred", "mixed");
  openEncoder(*context, options);
  return context;
}

class Animation {
 public:
  Animation(const path& target, const FilmTrack& track, AVPixelFormat pixels, image::PixelSize size,
            const FilmTexts& texts, const path& temporaryFolder)
      : encoder_(opened(track, pixels, size)),
        file_(target, fileFormat(track.container), *parametersOf(encoder_.context()), track.fps, Index::kAtStart,
              texts, temporaryFolder) {}

  AVFrame& frame() { return encoder_.frame(); }
  void encode() { encoder_.encode(sink_); }
  core::AtomicFile finish() {
    encoder_.drain(sink_);
    return file_.finish();
  }

 private:
  FrameEncoder encoder_;
  TrackWriter file_;
  std::int64_t packets_ = 0;
  FrameEncoder::PacketSink sink_ = [this](AVPacket& packet) { file_.write(packet, packets_++); };
};

/// Writes the palette into the frame's second plane, as opaque ARGB entries. Unused entries become transparent.
void setPalette(AVFrame& frame, const std::vector<Rgb>& palette) {
  auto* entries = reinterpret_cast<std::uint32_t*>(frame.data[1]);
  for (std::size_t i = 0; i < 256; ++i)
    entries[i] = i < palette.size() ? 0xFF000000u | static_cast<std::uint32_t>(palette[i][0]) << 16 |
                                          static_cast<std::uint32_t>(palette[i][1]) << 8 | palette[i][2]
                                    : 0;
}

}  // namespace

core::AtomicFile animate(const std::vector<path>& segments, const path& target, const FilmTrack& track,
                         const FilmTexts& texts, const path& temporaryFolder) {
  const bool gif = track.container == FilmContainer::kGif;
  std::optional<OrderedDither> dither;
  if (gif) dither.emplace(paletteOf(segments, track.colors));
  std::optional<Animation> film;
  readAll(segments, [&](const image::Image& picture) {
    const AVPixelFormat pixels = gif                     ? AV_PIX_FMT_PAL8
                                 : picture.channels == 4 ? AV_PIX_FMT_RGBA
                                                         : AV_PIX_FMT_RGB24;
    if (!film) film.emplace(target, track, pixels, picture.size, texts, temporaryFolder);
    AVFrame& frame = film->frame();
    if (gif) {
      setPalette(frame, dither->palette());
      dither->apply(
          picture,
          {frame.data[0], static_cast<std::size_t>(frame.linesize[0]) * static_cast<std::size_t>(frame.height)},
          frame.linesize[0]);
    } else {
      for (int y = 0; y < picture.size.height; ++y)
        std::copy_n(picture.at(0, y), picture.rowBytes(), frame.data[0] + std::ptrdiff_t{y} * frame.linesize[0]);
    }
    film->encode();
  });
  return film->finish();
}

}  // namespace poinsot::output
