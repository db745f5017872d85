// SPDX-License-Identifier: Apache-2.0
#include "compare/diff_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "core/text.h"
#include "figure/mark.h"
#include "stage/plot/plot_ticks.h"

namespace poinsot::compare {
namespace {

constexpr std::string_view kCsvHeader =
    "frame,t,verdict,differing_pixels,max,mean,rmse,psnr_db,ssim_mean,flip_mean,flip_max\n";

constexpr double kWidth = 1280, kHeight = 254, kLeft = kCurveLeft * kWidth, kRight = kCurveRight * kWidth;
constexpr std::size_t kMostPoints = 1600;

// Grey, amber and red, as on the HTML page; these shades suit filled areas.
constexpr const char* colorOf(Verdict verdict) {
  return verdict == Verdict::kIdentical ? "#c3c9cf" : verdict == Verdict::kNear ? "#c88a00" : "#b3261e";
}

/// Returns the start of a curve's SVG file. Earlier curves are recognised by it, because other figures start
/// differently.
std::string svgStart() {
  return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )",
                     kWidth, kHeight);
}

/// Curve of one figure of the frames, such as the mean FLIP error, with the figure's limit.
struct Series {
  const char* name;
  double limit;
  double top, bottom;  ///< y coordinates in the diagram
  double (*of)(const PictureDiff& frame);
};

struct Span {
  std::size_t first = 0, end = 0;
};

class CurvePicture {
 public:
  CurvePicture(const FilmDiff& diff, const NearRule& rule) : diff_(diff), rule_(rule) {}

  std::string svg() const {
    const Series series[] = {
        {"FLIP, largest of a pixel", rule_.flipMax, 28, 104,
         [](const PictureDiff& f) { return f.figures.flip.max; }},
        {"FLIP, mean", rule_.flipMean, 136, 212, [](const PictureDiff& f) { return f.figures.flip.mean; }}};
    std::string body;
    if (diff_.frames.empty()) {  // for example, if the films differ in size
      body = text(kLeft, kHeight / 2, "start", diff_.mismatch.empty() ? "no frames" : diff_.mismatch);
    } else {
      for (const Series& one : series) body += panel(one);
      body += verdicts() + timeAxis();
    }
    return figure::marked(
        figure::kSvgMark,
        svgStart() +
            fmt::format(
                "font-family=\"'Source Sans 3', 'Source Sans Pro', 'Noto Sans', sans-serif\" font-size=\"13\" "
                "fill=\"#24292f\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n{2}</svg>\n",
                kWidth, kHeight, body));
  }

 private:
  std::size_t points() const { return std::min(diff_.frames.size(), kMostPoints); }
  Span spanOf(std::size_t point) const {
    const std::size_t frames = diff_.frames.size();
    return {point * frames / points(), (point + 1) * frames / points()};
  }
  double xOf(double frame) const {
    const double last = std::max<double>(1, static_cast<double>(diff_.frames.size()) - 1);
    return kLeft + (kRight - kLeft) * frame / last;
  }
  template <class Figure>
  std::optional<double> mostOf(const Span& span, Figure figure) const {
    std::optional<double> most;
    for (std::size_t k = span.first; k < span.end; ++k)
      if (diff_.frames[k].hasFigures) most = std::max(most.value_or(0), figure(diff_.frames[k]));
    return most;
  }
  Verdict verdictOf(std::size_t point) const {
    const Span span = spanOf(point);
    Verdict worst = Verdict::kIdentical;
    for (std::size_t k = span.first; k < span.end; ++k) worst = std::max(worst, diff_.frames[k].verdict);
    return worst;
  }

  static std::string text(double x, double y, const char* anchor, const std::string& words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
  }
  static std::string level(double y, const char* style) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" {}/>\n", kLeft, y, kRight, style);
  }

  std::string panel(const Series& series) const {
    const double most = mostOf({0, diff_.frames.size()}, series.of).value_or(0);
    const auto ticks = stage::coveringTicks(0, most > 0 ? most : std::max(series.limit, 1e-3), 7);
    const double top = ticks.at(ticks.last);
    const auto yOf = [&](double value) { return series.bottom - (series.bottom - series.top) * value / top; };
    std::string svg =
        text(kLeft, series.top - 9, "start", fmt::format("{} (limit {:.4g})", series.name, series.limit));
    for (std::int64_t k = ticks.first; k <= ticks.last; k += std::max<std::int64_t>(1, (ticks.count() - 1) / 3)) {
      svg += level(yOf(ticks.at(k)), "stroke=\"#e4e8ec\"");
      svg += text(kLeft - 8, yOf(ticks.at(k)) + 4.5, "end", stage::tickDigits(ticks, k));
    }
    if (series.limit <= top) svg += level(yOf(series.limit), "stroke=\"#b3261e\" stroke-dasharray=\"5 4\"");
    return svg + line(series, yOf);
  }

  template <class Place>
  std::string line(const Series& series, Place yOf) const {
    std::string path;
    bool pen = false;
    for (std::size_t i = 0; i < points(); ++i) {
      const Span span = spanOf(i);
      const auto most = mostOf(span, series.of);
      if (most)
        path += fmt::format("{}{:.2f} {:.2f}", pen ? "L" : "M", xOf(static_cast<double>(span.first)), yOf(*most));
      pen = most.has_value();
    }
    if (path.empty()) return "";
    if (points() == 1) path += "h3";
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"#0f62ad\" stroke-width=\"1.6\" "
        "stroke-linejoin=\"round\"/>\n",
        path);
  }

  /// Returns a strip that shows the worst verdict at each point. Neighbours with equal verdicts share a rectangle.
  std::string verdicts() const {
    std::string svg;
    for (std::size_t i = 0, end = 0; i < points(); i = end) {
      for (end = i + 1; end < points() && verdictOf(end) == verdictOf(i);) ++end;
      // A point's part of the strip extends half a step to both sides.
      const double from = i == 0 ? kLeft : std::max(kLeft, xOf(static_cast<double>(spanOf(i).first) - 0.5));
      const double to =
          end == points() ? kRight : std::min(kRight, xOf(static_cast<double>(spanOf(end - 1).end) - 0.5));
      svg += fmt::format("<rect x=\"{:.2f}\" y=\"219\" width=\"{:.2f}\" height=\"7\" fill=\"{}\"/>\n", from,
                         std::max(1.0, to - from), colorOf(verdictOf(i)));
    }
    return svg;
  }

  std::string timeAxis() const {
    const bool timed = diff_.fps.num != 0;
    const double perFrame = timed ? 1 / diff_.fps.value() : 1;
    const double end = std::max<double>(1, static_cast<double>(diff_.frames.size()) - 1) * perFrame;
    const auto ticks = stage::innerTicks(0, end, 12);
    std::string svg;
    for (std::int64_t k = ticks.first; k <= ticks.last; ++k) {
      const double x = xOf(ticks.at(k) / perFrame);
      svg += fmt::format("<path d=\"M{:.2f} 226v5\" stroke=\"#6e7781\"/>\n", x);
      svg += text(x, 246, "middle", stage::tickDigits(ticks, k));
    }
    return svg + text(kLeft - 24, 246, "end", timed ? "t / s" : "frame");
  }

  const FilmDiff& diff_;
  const NearRule& rule_;
};

bool isCsv(const std::filesystem::path& file) { return file.extension() == ".csv"; }

}  // namespace

std::string curveCsv(const FilmDiff& diff) {
  std::string text(kCsvHeader);
  for (std::size_t k = 0; k < diff.frames.size(); ++k) {
    const PictureDiff& frame = diff.frames[k];
    if (!frame.hasFigures) {
      text += fmt::format("{},{},{},,,,,,,,\n", k, diff.time_s(k), toString(frame.verdict));
      continue;
    }
    const ImageDifference& d = frame.figures;
    text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{},{},{:.6g},{:.6g}\n", k, diff.time_s(k),
                        toString(frame.verdict), d.differingPixels, d.maxAbs, d.meanAbs, d.rmse,
                        d.psnr_dB ? fmt::format("{:.6g}", *d.psnr_dB) : "",
                        d.ssim ? fmt::format("{:.9g}", d.ssim->mean) : "", d.flip.mean, d.flip.max);
  }
  return text;
}

std::string curveSvg(const FilmDiff& diff, const NearRule& rule) { return CurvePicture(diff, rule).svg(); }

output::FileKind curveKind(const std::filesystem::path& file) {
  if (isCsv(file)) return output::textKind("a curve", std::string(kCsvHeader));
  if (file.extension() != ".svg")
    throw core::usageError(fmt::format("curve '{}': must be named NAME.csv or NAME.svg{}",
                                       core::printable(file.native()),
                                       core::smallLettersHint(file.native(), {".csv", ".svg"})));
  return {"a curve", [](const std::filesystem::path& earlier) {
            const auto rest = figure::markedRest(earlier, figure::kSvgMark);
            return rest && rest->starts_with(svgStart());
          }};
}

std::string curveText(const std::filesystem::path& file, const FilmDiff& diff, const NearRule& rule) {
  return isCsv(file) ? curveCsv(diff) : curveSvg(diff, rule);
}

}  // namespace poinsot::compare
