// SPDX-License-Identifier: Apache-2.0
#include "figure/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/expect.h"
#include "core/file_batch.h"
#include "core/text.h"
#include "figure/parts.h"
#include "figure/writers.h"

namespace poinsot::figure {
namespace {

constexpr double kInch_mm = 25.4;
constexpr const char* kUnlabelled = "-unlabelled.png";

// LaTeX gives the characters in this list a special meaning in file names.
void requireNameForLatex(const std::string& name) {
  if (name.find_first_of("%#$&{}\\^~\"") == std::string::npos) return;
  throw core::usageError(fmt::format(
      "{}: LaTeX cannot load a picture whose name has one of % # $ & {{ }} \\ ^ ~ \"", core::printable(name)));
}

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

std::vector<Bytes> tikzContents(const std::filesystem::path& target, const Figure& figure) {
  const std::string imageName = figureFiles(target).front().filename().string();
  Bytes png =
      image::encodePng(figure.imagePart, pngTexts(figure.options.title, figure.options.description), figure.dpi());
  return {std::move(png), bytesOf(tikzOf(figure, imageName))};
}

}  // namespace

std::optional<FigureMedium> figureMedium(const std::filesystem::path& target) {
  const std::string extension = target.extension().string();
  if (extension == ".pdf") return FigureMedium::kPdf;
  if (extension == ".svg") return FigureMedium::kSvg;
  if (extension == ".tex") return FigureMedium::kTikz;
  return std::nullopt;
}

std::vector<std::filesystem::path> figureFiles(const std::filesystem::path& target) {
  if (figureMedium(target) != FigureMedium::kTikz) return {target};
  const std::string imageName = target.stem().string() + kUnlabelled;
  requireNameForLatex(imageName);
  return {target.parent_path() / imageName, target};
}

std::vector<image::PngText> pngTexts(const std::string& title, const std::string& description) {
  std::vector<image::PngText> texts;
  if (!title.empty()) texts.push_back({"Title", title});
  if (!description.empty()) texts.push_back({"Description", description});
  return texts;
}

int pixelsAcross(double width_mm, double dpi) {
  return std::max(1, static_cast<int>(std::lround(width_mm / kInch_mm * dpi)));
}

draw::Picture imagePartOf(const draw::Picture& picture, FigureMedium medium) {
  return medium == FigureMedium::kTikz ? withoutType(picture) : surfacesOf(picture);
}

std::vector<std::vector<std::uint8_t>> figureContents(const std::filesystem::path& target,
                                                      const draw::Picture& picture, const image::Image& imagePart,
                                                      const FigureOptions& options) {
  const auto medium = figureMedium(target);
  POINSOT_EXPECT(medium.has_value());
  POINSOT_EXPECT(imagePart.size.width == picture.size_px.x && imagePart.size.height == picture.size_px.y);
  if (!(options.width_mm > 0 && std::isfinite(options.width_mm)))
    throw core::usageError(fmt::format("a figure's width must be more than 0 mm, got {} mm", options.width_mm));
  const Figure figure{picture, imagePart, options};
  if (*medium == FigureMedium::kPdf) return {pdfOf(figure)};
  if (*medium == FigureMedium::kSvg) return {bytesOf(svgOf(figure))};
  return tikzContents(target, figure);
}

void writeFigure(const std::filesystem::path& target, const draw::Picture& picture, const image::Image& imagePart,
                 const FigureOptions& options) {
  const auto contents = figureContents(target, picture, imagePart, options);
  const auto files = figureFiles(target);
  core::FileBatch batch;
  batch.write(files.front(), contents.front());
  for (std::size_t i = 1; i < files.size(); ++i) batch.writeBeside(files[i], contents[i]);
  batch.commit();
}

std::vector<glm::dvec2> labelAnchors(const draw::Picture& picture, FigureMedium medium,
                                     const FigureOptions& options) {
  const double scale = options.width_mm / kInch_mm * 72 / picture.size_px.x;
  std::vector<glm::dvec2> anchors;
  for (const draw::Text& label : labelsOf(picture)) {
    const glm::dvec2 p_px = label.baseline_px;
    const glm::dvec2 up{p_px.x, static_cast<double>(picture.size_px.y) - p_px.y};
    anchors.push_back(medium == FigureMedium::kSvg ? p_px : scale * up);
  }
  return anchors;
}

double Figure::pointsPerPixel() const { return options.width_mm / kInch_mm * 72 / picture.size_px.x; }

}  // namespace poinsot::figure
