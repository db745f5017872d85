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

/// Figures for notes: a picture on paper, its surfaces as an image, its lines and type as vectors.
///
///   const auto medium = figureMedium("top.pdf");                    // or .svg, .tex
///   const draw::Picture picture = ...;                              // composed for pixelsAcross(86, 600) pixels
///   const image::Image part = renderer.render(imagePartOf(picture, *medium), options);
///   writeFigure("top.pdf", picture, part, {.width_mm = 86, .title = ..., .description = ...});
namespace poinsot::figure {

enum class FigureMedium {
  kPdf,
  kSvg,
  kTikz,  ///< NAME.tex with the labels, for LaTeX to set, over NAME-unlabelled.png with all else
};

/// By the name's ending: .pdf, .svg, .tex.
std::optional<FigureMedium> figureMedium(const std::filesystem::path& target);

/// The files that a figure is made of; each rests on the one before, and the target is the last.
/// @throws core::Error(kUsage) for a name that LaTeX cannot load.
std::vector<std::filesystem::path> figureFiles(const std::filesystem::path& target);

/// What a PNG says of itself, by the keywords of its standard; an empty text is left out.
std::vector<image::PngText> pngTexts(const std::string& title, const std::string& description);

/// Pixels of a width in print, at least 1.
int pixelsAcross(double width_mm, double dpi);

struct FigureOptions {
  double width_mm = 86;     ///< of the whole picture; with its pixels this says how many make an inch
  std::string title;        ///< UTF-8; empty is none
  std::string description;  ///< the picture in words, for those who do not see it; empty is none
};

/// What of the picture the medium takes as an image: to be rendered by the caller, transparent (with fitAlpha() of
/// alpha.h) or not.
draw::Picture imagePartOf(const draw::Picture& picture, FigureMedium medium);

/// Returns the bytes of figureFiles(), in their order.
/// @throws as writeFigure(), except for files that cannot be written.
std::vector<std::vector<std::uint8_t>> figureContents(const std::filesystem::path& target,
                                                      const draw::Picture& picture, const image::Image& imagePart,
                                                      const FigureOptions& options);

/// Writes the figure, whole or not at all, durable when this returns; the same bytes for the same picture: no date
/// is written. Type is real text: it can be searched and copied, its font is embedded.
/// @pre `target` has one of the three endings, `imagePart` is imagePartOf() rendered in the picture's size.
/// @throws core::Error(kUsage) for labels that cannot be set, a width that is not positive or a name as above;
/// core::Error(kIo) when the file cannot be written; core::Error(kEncode) when cairo fails.
void writeFigure(const std::filesystem::path& target, const draw::Picture& picture, const image::Image& imagePart,
                 const FigureOptions& options);

/// Left ends of the labels' baselines in the medium's own units: PDF points (1/72 inch) and TikZ bp from the
/// bottom left corner, y up; SVG user units, which are the picture's pixels, from the top left corner, y down. In
/// the order of labelsOf().
std::vector<glm::dvec2> labelAnchors(const draw::Picture& picture, FigureMedium medium,
                                     const FigureOptions& options);

}  // namespace poinsot::figure
