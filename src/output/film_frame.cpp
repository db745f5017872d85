// SPDX-License-Identifier: Apache-2.0
#include "output/film_frame.h"

#include "core/expect.h"
#include "output/yuv.h"

namespace poinsot::output {
namespace {

YuvPlanes planesOf(AVFrame& frame, bool alpha) {
  YuvPlanes planes{frame.data[0],     frame.data[1],     frame.data[2],
                   frame.linesize[0], frame.linesize[1], frame.linesize[2]};
  if (alpha) {
    planes.alpha = frame.data[3];
    planes.alphaStride = frame.linesize[3];
  }
  return planes;
}

void fillBgra(AVFrame& frame, const image::Image& picture) {
  for (int y = 0; y < picture.size.height; ++y) {
    const std::uint8_t* from = picture.at(0, y);
    std::uint8_t* to = frame.data[0] + static_cast<std::ptrdiff_t>(y) * frame.linesize[0];
    for (int x = 0; x < picture.size.width; ++x, from += picture.channels, to += 4) {
      to[0] = from[2];
      to[1] = from[1];
      to[2] = from[0];
      to[3] = picture.channels == 4 ? from[3] : 255;
    }
  }
}

}  // namespace

void fillFrame(AVFrame& frame, const image::Image& picture) {
  POINSOT_EXPECT(picture.size.width == frame.width && picture.size.height == frame.height);
  switch (frame.format) {
    case AV_PIX_FMT_YUV420P:
      return convertToYuv420(picture, planesOf(frame, false));
    case AV_PIX_FMT_YUVA420P:
      return convertToYuva420(picture, planesOf(frame, true));
    case AV_PIX_FMT_YUV444P:
      return convertToYuv444(picture, planesOf(frame, false), 8);
    case AV_PIX_FMT_YUV444P10:
      return convertToYuv444(picture, planesOf(frame, false), 10);
    case AV_PIX_FMT_YUVA444P10:
      return convertToYuv444(picture, planesOf(frame, true), 10);
    case AV_PIX_FMT_BGR0:
    case AV_PIX_FMT_BGRA:
      return fillBgra(frame, picture);
    default:
      POINSOT_EXPECT(!"a pixel format that no encoder here has");
  }
}

void fillFrame(AVFrame& frame, const image::Image& picture, std::span<const image::PixelRect> changed) {
  if (frame.format != AV_PIX_FMT_YUV420P) return fillFrame(frame, picture);
  POINSOT_EXPECT(picture.size.width == frame.width && picture.size.height == frame.height);
  for (const image::PixelRect& part : changed) convertPartToYuv420(picture, planesOf(frame, false), part);
}

image::Image pictureOf(const AVFrame& frame) {
  POINSOT_EXPECT(frame.format == AV_PIX_FMT_BGR0 || frame.format == AV_PIX_FMT_BGRA);
  image::Image picture({frame.width, frame.height}, frame.format == AV_PIX_FMT_BGRA ? 4 : 3);
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* from = frame.data[0] + static_cast<std::ptrdiff_t>(y) * frame.linesize[0];
    std::uint8_t* to = picture.at(0, y);
    for (int x = 0; x < frame.width; ++x, from += 4, to += picture.channels) {
      to[0] = from[2];
      to[1] = from[1];
      to[2] = from[0];
      if (picture.channels == 4) to[3] = from[3];
    }
  }
  return picture;
}

}  // namespace poinsot::output
