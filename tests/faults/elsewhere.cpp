// SPDX-License-Identifier: Apache-2.0
// Library to preload that simulates another machine at another time. Environment variables control it:
//   ELSEWHERE_DAYS  the clock runs this number of days ahead
//   ELSEWHERE_HOST  the machine's name
//   ELSEWHERE_ASM   instructions that x264 may use, by its own names: "SSE2", "SSSE3", "AVX2"
//   ELSEWHERE_WAYS  if set, x264 may choose its algorithms by these instructions, which changes its stream
//   ELSEWHERE_MARK  file to create when x264 has accepted the instructions
//   ELSEWHERE_LACKS encoders to hide from libavcodec, by its own names: "libx264,gif"
//   ELSEWHERE_SETS  setting, "NAME=value", added to the environment after the program has cleared it
//   ELSEWHERE_HIDES libraries that cannot be opened at run time, by the start of their names: "libav"
#undef _FORTIFY_SOURCE  // with it, glibc defines functions that this file replaces
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

/// Settings, read when the library is loaded, because the program clears its environment.
const struct {
  const char* days = std::getenv("ELSEWHERE_DAYS");
  const char* host = std::getenv("ELSEWHERE_HOST");
  const char* assembly = std::getenv("ELSEWHERE_ASM");
  const char* ways = std::getenv("ELSEWHERE_WAYS");
  const char* mark = std::getenv("ELSEWHERE_MARK");
  const char* lacks = std::getenv("ELSEWHERE_LACKS");
  const char* sets = std::getenv("ELSEWHERE_SETS");
  const char* hides = std::getenv("ELSEWHERE_HIDES");
} kSettings;

time_t ahead_s() { return kSettings.days ? 86400 * std::atol(kSettings.days) : 0; }

using FindSymbol = void*(void* library, const char* name);

/// Returns the C library's dlsym, which this file replaces. Finds it by one of its known versions.
FindSymbol* realFindSymbol() {
  static FindSymbol* found = nullptr;
  for (const char* version : {"GLIBC_2.34", "GLIBC_2.17", "GLIBC_2.2.5"})
    if (!found) found = reinterpret_cast<FindSymbol*>(dlvsym(RTLD_NEXT, "dlsym", version));
  return found;
}

template <typename Function>
Function* real(Function*, const char* name) {
  return reinterpret_cast<Function*>(realFindSymbol()(RTLD_NEXT, name));
}

using OpenEncoder = void*(void* parameters);
using ParseParameter = int(void* parameters, const char* name, const char* value);

/// Sets x264's parameters before the encoder opens, as x264's own command line would. RTLD_NEXT does not find the
/// library, because it was loaded together with a library opened at run time.
void* open(const char* library, const char* opener, void* parameters) {
  void* x264 = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  const auto parse = reinterpret_cast<ParseParameter*>(realFindSymbol()(x264, "x264_param_parse"));
  const char *words = kSettings.assembly, *mark = kSettings.mark;
  if (kSettings.ways && parse) parse(parameters, "cpu-independent", "0");
  if (words && parse && parse(parameters, "asm", words) == 0 && mark)
    if (std::FILE* file = std::fopen(mark, "w")) std::fclose(file);
  return reinterpret_cast<OpenEncoder*>(realFindSymbol()(x264, opener))(parameters);
}

bool isLacked(const char* encoder) {
  if (!kSettings.lacks) return false;
  const std::string names = std::string(",") + kSettings.lacks + ',';
  return names.find(std::string(",") + encoder + ',') != std::string::npos;
}

using FindEncoder = const void*(const char* name);
FindEncoder* realFindEncoder = nullptr;

const void* findEncoder(const char* name) { return isLacked(name) ? nullptr : realFindEncoder(name); }

}  // namespace

extern "C" {

void* dlsym(void* library, const char* name) noexcept {
  void* found = realFindSymbol()(library, name);
  if (std::strcmp(name, "avcodec_find_encoder_by_name") != 0) return found;
  realFindEncoder = reinterpret_cast<FindEncoder*>(found);
  return reinterpret_cast<void*>(&findEncoder);
}

void* dlopen(const char* file, int flags) noexcept {
  static const auto next = real(&dlopen, "dlopen");
  const char* hidden = kSettings.hides;
  const bool hide = hidden && file && std::strncmp(file, hidden, std::strlen(hidden)) == 0;
  return next(hide ? (std::string("/nowhere/") + file).c_str() : file, flags);
}

int setenv(const char* name, const char* value, int replace) noexcept {
  static const auto next = real(&setenv, "setenv");
  if (kSettings.sets) putenv(const_cast<char*>(kSettings.sets));
  return next(name, value, replace);
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
  if (!kSettings.host) return next(name, size);
  std::snprintf(name, size, "%s", kSettings.host);
  return 0;
}

int uname(utsname* names) noexcept {
  static const auto next = real(&uname, "uname");
  const int code = next(names);
  if (kSettings.host && code == 0) std::snprintf(names->nodename, sizeof names->nodename, "%s", kSettings.host);
  return code;
}

// libavcodec calls the function with the number of the library's interface.
void* x264_encoder_open_164(void* parameters) {
  return open("libx264.so.164", "x264_encoder_open_164", parameters);
}
void* x264_encoder_open_165(void* parameters) {
  return open("libx264.so.165", "x264_encoder_open_165", parameters);
}

}  // extern "C"
