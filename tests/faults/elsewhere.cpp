// SPDX-License-Identifier: Apache-2.0
// A library to be preloaded: another machine at another time. Told by the environment:
//   ELSEWHERE_DAYS  the clock runs so many days ahead
//   ELSEWHERE_HOST  the machine's name
//   ELSEWHERE_ASM   the instructions that x264 may use, in its words: "SSE2", "SSSE3", "AVX2"
//   ELSEWHERE_MARK  a file to create when x264 was told
//   ELSEWHERE_LACKS encoders that libavcodec lacks, by its own names: "libx264,gif"
#include <dlfcn.h>
#include <sys/time.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

const char* setting(const char* name) { return std::getenv(name); }

time_t ahead_s() {
  const char* days = setting("ELSEWHERE_DAYS");
  return days ? 86400 * std::atol(days) : 0;
}

template <typename Function>
Function* real(Function*, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

using OpenEncoder = void*(void* parameters);
using ParseParameter = int(void* parameters, const char* name, const char* value);

/// Before it opens, as its own command line would.
void* open(OpenEncoder* opener, void* parameters) {
  static const auto parse = reinterpret_cast<ParseParameter*>(dlsym(RTLD_NEXT, "x264_param_parse"));
  const char* words = setting("ELSEWHERE_ASM");
  const char* mark = setting("ELSEWHERE_MARK");
  if (words && parse && parse(parameters, "asm", words) == 0 && mark)
    if (std::FILE* file = std::fopen(mark, "w")) std::fclose(file);
  return opener(parameters);
}

bool isLacked(const char* encoder) {
  const char* lacked = setting("ELSEWHERE_LACKS");
  if (!lacked) return false;
  const std::string names = std::string(",") + lacked + ',';
  return names.find(std::string(",") + encoder + ',') != std::string::npos;
}

}  // namespace

struct AVCodec;

extern "C" {

const AVCodec* avcodec_find_encoder_by_name(const char* name) {
  static const auto next = real(&avcodec_find_encoder_by_name, "avcodec_find_encoder_by_name");
  return isLacked(name) ? nullptr : next(name);
}

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  static const auto next = real(&clock_gettime, "clock_gettime");
  const int code = next(clock, now);
  if (code == 0 && clock == CLOCK_REALTIME) now->tv_sec += ahead_s();
  return code;
}

int gettimeofday(timeval* now, void* zone) noexcept {
  static const auto next = real(&gettimeofday, "gettimeofday");
  const int code = next(now, zone);
  if (code == 0) now->tv_sec += ahead_s();
  return code;
}

time_t time(time_t* now) noexcept {
  timespec exact{};
  clock_gettime(CLOCK_REALTIME, &exact);
  if (now) *now = exact.tv_sec;
  return exact.tv_sec;
}

int gethostname(char* name, size_t size) noexcept {
  static const auto next = real(&gethostname, "gethostname");
  const char* host = setting("ELSEWHERE_HOST");
  if (!host) return next(name, size);
  std::snprintf(name, size, "%s", host);
  return 0;
}

int uname(utsname* names) noexcept {
  static const auto next = real(&uname, "uname");
  const int code = next(names);
  if (const char* host = setting("ELSEWHERE_HOST"); host && code == 0)
    std::snprintf(names->nodename, sizeof names->nodename, "%s", host);
  return code;
}

// libavcodec calls it by the number of the library's interface.
void* x264_encoder_open_164(void* parameters) {
  return open(reinterpret_cast<OpenEncoder*>(dlsym(RTLD_NEXT, "x264_encoder_open_164")), parameters);
}
void* x264_encoder_open_165(void* parameters) {
  return open(reinterpret_cast<OpenEncoder*>(dlsym(RTLD_NEXT, "x264_encoder_open_165")), parameters);
}

}  // extern "C"
