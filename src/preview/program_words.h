// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "preview/picture_press.h"
#include "preview/preview_server.h"

/// Arguments with which `poinsot` makes what the page shows.
namespace poinsot::preview {

/// Format in which the page saves a picture.
struct StillFormat {
  std::string_view word;    ///< word in the page's requests
  std::string_view target;  ///< end of the name for -o
  std::string_view file;    ///< end of the name of the file that the browser saves
  std::string_view type;    ///< media type of this file
};

/// Returns the format with a name: "png", "pdf", "svg", "tex", or "tex-image" for the image of a TeX figure.
/// Returns nullptr for other names.
const StillFormat* stillFormat(std::string_view word);

/// Returns the film time of a frame in s. A number outside the film gives the first or last frame.
double frameTime_s(const scene::Scene& scene, std::int64_t frame);

/// Returns a file name without an ending, such as "book_1300ms". It contains no characters that need quotes in a
/// shell, in LaTeX or in HTTP headers.
std::string stillName(const PreviewRequest& request, double time_s);

/// Returns the arguments of `still`, or of `sweep` for a sweep.
/// @param target  value of -o
std::vector<std::string> stillWords(const PreviewRequest& request, const PageChanges& changes, double time_s,
                                    const std::string& target);

/// Returns the arguments of `render`, or of `sweep` for a sweep, with progress as JSON.
/// @param target  value of -o; empty for the default
std::vector<std::string> filmWords(const PreviewRequest& request, const PageChanges& changes,
                                   const std::string& target);

}  // namespace poinsot::preview
