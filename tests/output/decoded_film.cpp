// SPDX-License-Identifier: Apache-2.0
#include "decoded_film.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace poinsot::output {
namespace {

void check(int code, const char* what) {
  if (code < 0) throw std::runtime_error(what);
}

std::vector<std::uint8_t> plane(const AVFrame& frame, int index) {
  const int shift = index == 0 ? 0 : 1;
  const int width = frame.width >> shift, height = frame.height >> shift;
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = frame.data[index] + y * frame.linesize[index];
    bytes.insert(bytes.end(), row, row + width);
  }
  return bytes;
}

void receive(AVCodecContext* decoder, AVFrame* frame, std::vector<DecodedFrame>& out) {
  while (avcodec_receive_frame(decoder, frame) >= 0)
    out.push_back(
        {frame->pts, frame->pict_type == AV_PICTURE_TYPE_I, plane(*frame, 0), plane(*frame, 1), plane(*frame, 2)});
}

}  // namespace

std::vector<DecodedFrame> decoded(const std::filesystem::path& film) {
  AVFormatContext* format = nullptr;
  check(avformat_open_input(&format, ("file:" + film.native()).c_str(), nullptr, nullptr), "open");
  const AVCodecParameters* parameters = format->streams[0]->codecpar;
  AVCodecContext* decoder = avcodec_alloc_context3(avcodec_find_decoder(parameters->codec_id));
  check(avcodec_parameters_to_context(decoder, parameters), "parameters");
  decoder->err_recognition = AV_EF_EXPLODE;
  check(avcodec_open2(decoder, nullptr, nullptr), "decoder");
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  std::vector<DecodedFrame> frames;
  while (av_read_frame(format, packet) >= 0) {
    check(avcodec_send_packet(decoder, packet), "send");
    receive(decoder, frame, frames);
    av_packet_unref(packet);
  }
  check(avcodec_send_packet(decoder, nullptr), "drain");
  receive(decoder, frame, frames);
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&decoder);
  avformat_close_input(&format);
  return frames;
}

std::map<std::string, std::string> probed(const std::filesystem::path& film) {
  const std::string command =
      "ffprobe -v error -select_streams v:0 -count_packets -show_streams -show_format -of default=nw=1 'file:" +
      film.native() + "'";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("ffprobe");
  std::map<std::string, std::string> facts;
  for (char line[1024]; std::fgets(line, sizeof line, pipe) != nullptr;) {
    std::string text(line);
    text.pop_back();
    const auto equals = text.find('=');
    // The stream comes before the file, so that the stream's "duration" is kept.
    if (equals != std::string::npos) facts.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  if (::pclose(pipe) != 0) throw std::runtime_error("ffprobe failed");
  return facts;
}

std::vector<image::Image> shown(const std::filesystem::path& film, image::PixelSize size, int count) {
  // ffmpeg's own decoder of VP9 drops alpha.
  const char* decoder =
      film.extension() == ".webm" && probed(film).at("codec_name") == "vp9" ? "-c:v libvpx-vp9 " : "";
  const std::string command =
      "ffmpeg -v error " + std::string(decoder) + "-i 'file:" + film.native() +
      "' -vf scale=flags=accurate_rnd+full_chroma_int+full_chroma_inp -fps_mode passthrough "
      "-f rawvideo -pix_fmt rgba -";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("ffmpeg");
  std::vector<image::Image> pictures;
  image::Image picture(size, 4);
  while (std::fread(picture.pixels.data(), 1, picture.pixels.size(), pipe) == picture.pixels.size())
    if (static_cast<int>(pictures.size()) < count) pictures.push_back(picture);
  if (::pclose(pipe) != 0) return {};
  return pictures;
}

FilmFormat h264(double crf) {
  FilmFormat format;
  format.crf = crf;
  return format;
}

image::Image movingDisc(image::PixelSize size, std::int64_t k) {
  image::Image picture(size, 3);
  const double centre = size.width * (0.2 + 0.02 * static_cast<double>(k)), radius = size.height * 0.2;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const double inside = std::clamp(radius - std::hypot(x - centre, y - size.height * 0.5), 0.0, 1.0);
      const double line = std::clamp(1.5 - std::abs(y - size.height * 0.5 - 0.3 * (x - centre)), 0.0, 1.0);
      std::uint8_t* p = picture.at(x, y);
      p[0] = static_cast<std::uint8_t>(40 + 200 * inside);
      p[1] = static_cast<std::uint8_t>(60 + 60.0 * x / size.width + 100 * line);
      p[2] = static_cast<std::uint8_t>(90 + 60.0 * y / size.height);
    }
  return picture;
}

}  // namespace poinsot::output
