// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>

#include "cli/commands.h"
#include "core/version.h"
#include "output/library_versions.h"

namespace poinsot::cli {

std::string versionText() {
  std::string text = fmt::format("poinsot {}\n", core::version());
  for (const auto& library : output::libraryVersions())
    fmt::format_to(std::back_inserter(text), "{} {}\n", library.name, library.version);
  return text +
         "OpenGL 3.3 through OSMesa or EGL, opened at run time (poinsot doctor)\n"
         "Sources: Apache-2.0. With an FFmpeg that includes x264, the program as a whole is under the GPL.\n";
}

}  // namespace poinsot::cli
