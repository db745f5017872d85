// SPDX-License-Identifier: Apache-2.0
#include "output/ffmpeg_library.h"

#include "core/shared_library.h"

namespace poinsot::output {

// Two macros are needed: POINSOT_OPENED expands the version macro to a number, and POINSOT_TEXT makes it a string.
#define POINSOT_TEXT(words) #words
#define POINSOT_OPENED(name, major) \
  core::SharedLibrary(name ".so." POINSOT_TEXT(major), name POINSOT_TEXT(major), core::ErrorKind::kEncode)
#define POINSOT_LOAD(function) library.load(function, #function);

// Creates nothing that is destroyed at exit, because owners of FFmpeg objects may be destroyed later.
Ffmpeg::Ffmpeg() {
  {
    const auto library = POINSOT_OPENED("libavutil", LIBAVUTIL_VERSION_MAJOR);
    POINSOT_AVUTIL_FUNCTIONS(POINSOT_LOAD)
  }
  {
    const auto library = POINSOT_OPENED("libavcodec", LIBAVCODEC_VERSION_MAJOR);
    POINSOT_AVCODEC_FUNCTIONS(POINSOT_LOAD)
  }
  {
    const auto library = POINSOT_OPENED("libavformat", LIBAVFORMAT_VERSION_MAJOR);
    POINSOT_AVFORMAT_FUNCTIONS(POINSOT_LOAD)
  }
  {
    const auto library = POINSOT_OPENED("libswscale", LIBSWSCALE_VERSION_MAJOR);
    POINSOT_SWSCALE_FUNCTIONS(POINSOT_LOAD)
  }
}

const Ffmpeg& ffmpeg() {
  static const Ffmpeg functions;
  return functions;
}

}  // namespace poinsot::output
