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

/// Figures for printed notes. The surfaces of a picture become an image; lines and text become vector graphics.
///
///   const auto medium = figureMedium("top.pdf");                    // or .svg, .tex
///   const draw::Picture picture = ...;                              // composed for pixelsAcross(86, 600) pixels
///   const image::Image part = renderer.render(imagePartOf(picture, *medium), options);
///   writeFigure("top.pdf", picture, part, {.width_mm = 86, .title = ..., .description = ...});
namespace poinsot::figure {

enum class FigureMedium {
  kPdf,
  kSvg,
  kTikz,  ///< NAME.tex with labels that LaTeX typesets, over NAME-unlabelled.png with everything else
};

/// Returns the medium for a file name that ends in .pdf, .svg or .tex. Returns nullopt for other names.
std::optional<FigureMedium> figureMedium(const std::filesystem::path& target);

/// Returns the files that a figure consists of. `target` comes last; each file refers to the one before.
/// @throws core::Error(kUsage) for a name that LaTeX cannot load.
std::vector<std::filesystem::path> figureFiles(const std::filesystem::path& target);

/// Returns the text chunks of a PNG with the standard keywords Title and Description. Empty texts are left out.
std::vector<image::PngText> pngTexts(const std::string& title, const std::string& description);

/// Returns the number of pixels across a printed width, at least 1.
int pixelsAcross(double width_mm, double dpi);

struct FigureOptions {
  double width_mm = 86;  ///< printed width of the complete picture; its width in pixels then gives the resolution
  std::string title;     ///< title in UTF-8; empty if there is none
  std::string description;  ///< description in words for readers who cannot see the picture; empty if none
  bool svgText = false;     ///< writes the labels of an SVG as text in Latin Modern, which other programs can edit
};

/// Returns the part of the picture that the figure contains as an image. Render this part and pass the result to
/// writeFigure(). For a transparent background, also call fitAlpha() of alpha.h.
draw::Picture imagePartOf(const draw::Picture& picture, FigureMedium medium);

/// Returns the contents of the files of figureFiles(), in the same order.
/// @throws as writeFigure(), except for files that cannot be written.
std::vector<std::vector<std::uint8_t>> figureContents(const std::filesystem::path& target,
                                                      const draw::Picture& picture, const image::Image& imagePart,
                                                      const FigureOptions& options);

/// Writes a figure, either completely or not at all. When the function returns, the files are safely on the disk.
/// The same picture gives the same bytes, because no date is written. Text can be selected and searched, and its
/// font is embedded.
/// @pre `target` has one of the three endings, `imagePart` is imagePartOf() rendered in the picture's size.
/// @throws core::Error(kUsage) for labels that cannot be set, a width that is not positive, or a name that LaTeX
/// cannot load; core::Error(kIo) if a file cannot be written; core::Error(kEncode) if cairo fails.
void writeFigure(const std::filesystem::path& target, const draw::Picture& picture, const image::Image& imagePart,
                 const FigureOptions& options);

/// Returns the positions of the labels, in the order of labelsOf(). A position is the left end of a baseline. PDF
/// uses points (1/72 inch) and TikZ bp, both from the bottom left corner, y up. SVG uses pixels of the picture
/// from the top left corner, y down.
std::vector<glm::dvec2> labelAnchors(const draw::Picture& picture, FigureMedium medium,
                                     const FigureOptions& options);

}  // namespace poinsot::figure
