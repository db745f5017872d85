// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "draw/picture.h"
#include "image/image.h"
#include "image/png_file.h"

/// Figures for notes: a picture on paper, with its surfaces as an image, and its lines and type as vectors.
///
///   const auto medium = figureMedium("top.pdf");                    // or .svg, .tex
///   const draw::Picture picture = ...;                              // composed for pixelsAcross(86, 600) pixels
///   const image::Image part = renderer.render(imagePartOf(picture, *medium), options);
///   writeFigure("top.pdf", picture, part, {.width_mm = 86, .title = ..., .description = ...});
namespace poinsot::figure {

enum class FigureMedium {
  kPdf,
  kSvg,
  kTikz,  ///< NAME.tex with the labels, set by LaTeX, over NAME-unlabelled.png with everything else
};

/// Returns the medium by the extension .pdf, .svg or .tex; nullopt for any other.
std::optional<FigureMedium> figureMedium(const std::filesystem::path& target);

/// Returns the files of a figure, the target last. Each file depends on the one before.
/// @throws core::Error(kUsage) for a name that LaTeX cannot load.
std::vector<std::filesystem::path> figureFiles(const std::filesystem::path& target);

/// Returns the texts of a PNG, by the standard keywords Title and Description. Empty texts are left out.
std::vector<image::PngText> pngTexts(const std::string& title, const std::string& description);

/// Returns the number of pixels in a printed width, at least 1.
int pixelsAcross(double width_mm, double dpi);

struct FigureOptions {
  double width_mm = 86;     ///< width of the whole picture; with the picture's pixels it gives the resolution
  std::string title;        ///< UTF-8; empty if none
  std::string description;  ///< the picture in words, for readers who do not see it; empty if none
};

/// Returns the part of the picture that the medium takes as an image. The caller renders that part, transparent
/// (with fitAlpha() of alpha.h) or not.
draw::Picture imagePartOf(const draw::Picture& picture, FigureMedium medium);

/// Returns the bytes of figureFiles(), in the same order.
/// @throws as writeFigure(), except for files that cannot be written.
std::vector<std::vector<std::uint8_t>> figureContents(const std::filesystem::path& target,
                                                      const draw::Picture& picture, const image::Image& imagePart,
                                                      const FigureOptions& options);

/// Writes the figure, completely or not at all; its files are durable when the function returns. The same picture
/// gives the same bytes, because no date is written. Type is real text, searchable and with an embedded font.
/// @pre `target` has one of the three endings, `imagePart` is imagePartOf() rendered in the picture's size.
/// @throws core::Error(kUsage) for labels that cannot be set, a width that is not positive, or a name that LaTeX
/// cannot load; core::Error(kIo) if a file cannot be written; core::Error(kEncode) if cairo fails.
void writeFigure(const std::filesystem::path& target, const draw::Picture& picture, const image::Image& imagePart,
                 const FigureOptions& options);

/// Returns the left ends of the labels' baselines, in the order of labelsOf() and in the medium's own units: PDF
/// points (1/72 inch) and TikZ bp from the bottom left corner, y up; SVG user units, which are the picture's
/// pixels, from the top left corner, y down.
std::vector<glm::dvec2> labelAnchors(const draw::Picture& picture, FigureMedium medium,
                                     const FigureOptions& options);

}  // namespace poinsot::figure
