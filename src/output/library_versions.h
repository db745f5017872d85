// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace poinsot::output {

struct LibraryVersion {
  std::string name;
  std::string version;
};

/// Returns the versions of libpng, libavcodec, libavformat and x264, as loaded at run time. x264 states its
/// version only in a stream, so a tiny frame is encoded for it; if this fails, x264 is left out. If FFmpeg cannot
/// be opened, the entry "FFmpeg" has the reason instead of a version.
std::vector<LibraryVersion> libraryVersions();

}  // namespace poinsot::output
