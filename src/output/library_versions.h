// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace poinsot::output {

struct LibraryVersion {
  std::string name;
  std::string version;
};

/// libpng, libavcodec, libavformat and x264, as loaded at run time. x264 tells its version only in a stream, so
/// one tiny frame is encoded; it is left out where that does not work. Where FFmpeg cannot be opened, "FFmpeg" has
/// the reason in place of a version.
std::vector<LibraryVersion> libraryVersions();

}  // namespace poinsot::output
