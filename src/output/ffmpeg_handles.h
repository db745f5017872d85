// SPDX-License-Identifier: Apache-2.0
// Smart pointers for libav objects, and checkAv() for its errors. Included by .cpp files of this folder only.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"
#include "output/ffmpeg_library.h"

namespace poinsot::output {

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

/// Deleter for contexts from avio_alloc_context(). It also frees the buffer that the context has now, because
/// libav may have replaced the first buffer.
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

/// Options that a libav function takes when it opens a file or a codec. The function removes the options that it
/// accepts; expectAllTaken() fails if any option is left.
class AvOptions {
 public:
  AvOptions() = default;
  ~AvOptions() {
    if (entries_ != nullptr) ffmpeg().av_dict_free(&entries_);  // null if FFmpeg could not be opened
  }
  AvOptions(const AvOptions&) = delete;
  AvOptions& operator=(const AvOptions&) = delete;

  void set(const char* key, const std::string& value);
  AVDictionary** address() { return &entries_; }
  void expectAllTaken() const;

 private:
  AVDictionary* entries_ = nullptr;
};

/// Checks the result of a libav function. @returns `code` if it is not negative.
/// @throws core::Error of the given kind with the text "DOING: reason" and the last line that libav logged on this
///   thread.
int checkAv(int code, std::string_view doing, core::ErrorKind kind = core::ErrorKind::kEncode);

/// Checks that a libav function has allocated an object, and returns the object.
/// @throws std::bad_alloc if the pointer is null, because these functions fail only for lack of memory.
template <class Ptr>
Ptr checkAlloc(Ptr thing) {
  if (!thing) throw std::bad_alloc();
  return thing;
}

/// Checks that a path is a regular file. libav would wait for the writer of a pipe, and would read a device
/// forever.
/// @throws core::Error(kIo) otherwise.
void expectRegularFile(const std::filesystem::path& path);

/// Returns a path as a libav URL. Without the prefix "file:", libav would read "a:b" as a protocol.
std::string fileUrl(const std::filesystem::path& path);

CodecParametersPtr parametersOf(const AVCodecContext& context);

/// Makes libav store its last error line for checkAv() instead of writing it to stderr. Repeated calls are cheap.
void captureAvLog();

}  // namespace poinsot::output
