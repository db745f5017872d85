// SPDX-License-Identifier: Apache-2.0
// Owners of libav's things and the one translator of its errors. Included by .cpp files of this folder only.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"
#include "output/ffmpeg_library.h"

namespace poinsot::output {

/// Calls a libav function that takes the address of the pointer and clears it.
template <auto kFree>
struct AvDeleter {
  template <class T>
  void operator()(T* thing) const {
    (ffmpeg().*kFree)(&thing);
  }
};

struct FormatOutputDeleter {
  void operator()(AVFormatContext* context) const { ffmpeg().avformat_free_context(context); }
};

/// A context made by avio_alloc_context: its buffer may have been replaced and is ours to free.
struct IoDeleter {
  void operator()(AVIOContext* io) const {
    ffmpeg().av_freep(&io->buffer);
    ffmpeg().avio_context_free(&io);
  }
};

using CodecContextPtr = std::unique_ptr<AVCodecContext, AvDeleter<&Ffmpeg::avcodec_free_context>>;
using CodecParametersPtr = std::unique_ptr<AVCodecParameters, AvDeleter<&Ffmpeg::avcodec_parameters_free>>;
using FramePtr = std::unique_ptr<AVFrame, AvDeleter<&Ffmpeg::av_frame_free>>;
using PacketPtr = std::unique_ptr<AVPacket, AvDeleter<&Ffmpeg::av_packet_free>>;
using FormatInputPtr = std::unique_ptr<AVFormatContext, AvDeleter<&Ffmpeg::avformat_close_input>>;
using FormatOutputPtr = std::unique_ptr<AVFormatContext, FormatOutputDeleter>;
using IoPtr = std::unique_ptr<AVIOContext, IoDeleter>;

/// Options for an open call, which takes out those it knows; the rest is a mistake.
class AvOptions {
 public:
  AvOptions() = default;
  ~AvOptions() {
    if (entries_ != nullptr) ffmpeg().av_dict_free(&entries_);  // else FFmpeg may be what was missing
  }
  AvOptions(const AvOptions&) = delete;
  AvOptions& operator=(const AvOptions&) = delete;

  void set(const char* key, const std::string& value);
  AVDictionary** address() { return &entries_; }
  /// @throws core::Error(kEncode) if one was not taken.
  void expectAllTaken() const;

 private:
  AVDictionary* entries_ = nullptr;
};

/// @returns code if it is no error.
/// @throws core::Error of the kind: "DOING: reason", with the last line that libav logged on this thread.
int checkAv(int code, std::string_view doing, core::ErrorKind kind = core::ErrorKind::kEncode);

/// The pointer if there is one.
/// @throws std::bad_alloc: libav's constructors fail for want of memory only.
template <class Ptr>
Ptr checkAlloc(Ptr thing) {
  if (!thing) throw std::bad_alloc();
  return thing;
}

/// libav would wait for the writer of a pipe and read a device for ever.
/// @throws core::Error(kIo) unless it is a regular file.
void expectRegularFile(const std::filesystem::path& path);

/// A path as libav's names of files: without the prefix "a:b" would be a protocol.
std::string fileUrl(const std::filesystem::path& path);

CodecParametersPtr parametersOf(const AVCodecContext& context);

/// From here on libav writes nothing to stderr: its last error line is kept for checkAv. Cheap to call again.
void captureAvLog();

}  // namespace poinsot::output
