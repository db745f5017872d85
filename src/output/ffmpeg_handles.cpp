// SPDX-License-Identifier: Apache-2.0
#include "output/ffmpeg_handles.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <mutex>
#include <new>

#include "core/file_error.h"
#include "core/regular_file.h"
#include "core/text.h"

namespace poinsot::output {
namespace {

// Last error line of libav. A plain array, because libav calls keepLine() from C, where an exception is not
// allowed.
thread_local std::array<char, 256> lastLine{};

void keepLine(void* sender, int level, const char* format, va_list arguments) {
  if (level > AV_LOG_ERROR) return;
  int atLineStart = 1;
  ffmpeg().av_log_format_line(sender, level, format, arguments, lastLine.data(), static_cast<int>(lastLine.size()),
                              &atLineStart);
}

/// Returns the reason from a log line such as "[libx264 @ 0x5581...] reason\n".
std::string_view reasonIn(std::string_view line) {
  if (line.starts_with('[')) line.remove_prefix(std::min(line.size(), line.find("] ") + 2));
  while (line.ends_with('\n')) line.remove_suffix(1);
  return line;
}

std::string systemReason(int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  ffmpeg().av_strerror(code, text.data(), text.size());
  return text.data();
}

}  // namespace

void captureAvLog() {
  static std::once_flag once;
  std::call_once(once, [] { ffmpeg().av_log_set_callback(keepLine); });
  lastLine[0] = 0;
}

int checkAv(int code, std::string_view doing, core::ErrorKind kind) {
  if (code >= 0) return code;
  const std::string line = core::printable(reasonIn(lastLine.data()));
  throw core::Error(kind,
                    fmt::format("{}: {}{}", doing, systemReason(code), line.empty() ? "" : " (" + line + ")"));
}

CodecParametersPtr parametersOf(const AVCodecContext& context) {
  auto parameters = checkAlloc(CodecParametersPtr(ffmpeg().avcodec_parameters_alloc()));
  checkAv(ffmpeg().avcodec_parameters_from_context(parameters.get(), &context), "describing the stream");
  return parameters;
}

void expectRegularFile(const std::filesystem::path& path) {
  struct stat status {};
  const core::FileHandle file = core::openForReading(path);
  const int code = file && ::fstat(file.get(), &status) == 0 ? 0 : errno;
  if (code == 0 && S_ISREG(status.st_mode)) return;
  const std::string why =
      code == 0 ? "not a regular file" : fmt::format("cannot be read: {}", std::strerror(code));
  throw core::FileError(core::ErrorKind::kIo, fmt::format("{}: {}", core::printable(path.native()), why), path,
                        S_ISDIR(status.st_mode) ? EISDIR : code);
}

std::string fileUrl(const std::filesystem::path& path) { return "file:" + path.native(); }

void AvOptions::set(const char* key, const std::string& value) {
  if (ffmpeg().av_dict_set(&entries_, key, value.c_str(), 0) < 0) throw std::bad_alloc();
}

void AvOptions::expectAllTaken() const {
  if (const AVDictionaryEntry* left = ffmpeg().av_dict_get(entries_, "", nullptr, AV_DICT_IGNORE_SUFFIX))
    throw core::encodeError(fmt::format("this FFmpeg does not support the option {}={}", left->key, left->value));
}

}  // namespace poinsot::output
