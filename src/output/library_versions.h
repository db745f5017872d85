// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace poinsot::output {

struct LibraryVersion {
  std::string name;
  std::string version;
};

/// Returns the versions of libpng, libavcodec, libavformat and x264, as loaded at run time. x264 gives its version
/// only in a stream, so one tiny frame is encoded; if that fails, x264 is left out. If FFmpeg cannot be opened,
/// the entry "FFmpeg" has the reason instead of a version.
std::vector<LibraryVersion> libraryVersions();

}  // namespace poinsot::output
