// SPDX-License-Identifier: Apache-2.0
#include "stage/plot/plot_figure.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/expect.h"
#include "stage/plot/plot_curve.h"
#include "stage/plot/plot_frame.h"
#include "stage/plot/plot_tones.h"
#include "stage/plot/plot_values.h"
#include "stage/quantity_track.h"

namespace poinsot::stage {
namespace {

constexpr double kType = 0.027;                 // size of the text, as a fraction of Sizing::type_px
constexpr double kCurve = 1.25, kCursor = 0.6;  // line widths, as multiples of an ordinary line
constexpr double kCurveDot = 0.2;               // radius of the cursor's dot, in em
constexpr float kFaint = 0.62f;                 // mix towards the paper, for the future part of a curve
// Tolerances for simplified(), as fractions of the axes' lengths. In a plot of 2000 pixels, kTolerance is a
// twentieth of a pixel.
constexpr double kTolerance = 2.5e-5, kWidestTolerance = 5e-4;
constexpr int kColumns = 4096;  // columns of perColumn(); half as many as pixels in the widest picture
constexpr std::size_t kMostPoints = 20'000;  // largest number of points of a curve; limits the drawing time
constexpr std::size_t kPointsPerPixel = 4;
constexpr double kLeastArea = 0.4;      // smallest fraction of the panel's width and height for curves
constexpr double kSmallestArea = 0.25;  // kLeastArea if the text is not larger than Sizing::least_px

// Limits the number of points. A curve that has too many points even at the widest tolerance repeats similar
// loops, so its beginning already shows the complete curve.
std::vector<PlotPoint> bounded(const std::vector<PlotPoint>& points) {
  std::vector<PlotPoint> kept = simplified(points, kTolerance);
  if (kept.size() > kMostPoints) kept = simplified(points, kWidestTolerance);
  if (kept.size() > kMostPoints) kept.resize(kMostPoints);
  return kept;
}

std::string namesOf(const QuantityTrack& track, std::size_t count) {
  std::string names;
  for (std::size_t i = 0; i < count; ++i) names += (i == 0 ? "" : ",\\,") + track.tex(i);
  return names;
}

std::vector<int> tracked(const scene::Plot& plot) {
  POINSOT_EXPECT(!plot.quantities.empty() && (!plot.x || plot.quantities.size() == 1));
  for (const int which : plot.quantities)
    POINSOT_EXPECT(scene::stateQuantity(which).unit == scene::stateQuantity(plot.quantities[0]).unit);
  std::vector<int> all = plot.quantities;
  if (plot.x) all.push_back(*plot.x);
  return all;
}

PlotRanges rangesOf(const QuantityTrack& track, const scene::Plot& plot) {
  PlotRanges all{track.range(0), {}};
  for (std::size_t i = 1; i < plot.quantities.size(); ++i) all.y = joined(all.y, track.range(i));
  if (plot.x) all.x = track.range(1);
  return all;
}

}  // namespace

PlotRanges joined(const PlotRanges& a, const PlotRanges& b) {
  POINSOT_EXPECT(a.x.has_value() == b.x.has_value());
  return {joined(a.y, b.y), a.x ? std::optional(joined(*a.x, *b.x)) : std::nullopt};
}

struct PlotFigure::Plan {
  scene::Plot plot;
  scene::Style style;
  bool repeats;
  Palette colors;
  std::vector<draw::Color> tones;
  QuantityTrack track;
  PlotRanges ranges;
  PlotFrame frame;
  std::vector<PlotPath> curves;

  Plan(const scene::Scene& scene, const scene::Plot& p, std::shared_ptr<const physics::Motion> motion,
       const std::optional<PlotRanges>& least)
      : plot(p),
        style(scene.style),
        repeats(scene.time.loop.has_value()),
        colors(palette(style)),
        tones(quantityColors(colors, plot.quantities)),
        track(scene, std::move(motion), tracked(plot)),
        ranges(rangesOf(track, plot)) {
    if (least) ranges = joined(ranges, *least);
    makeFrame();
    for (std::size_t i = 0; i < plot.quantities.size(); ++i) curves.push_back(curve(i));
  }

  bool isPortrait() const { return plot.x.has_value(); }

  double shownTime_s(double filmTime_s) const {
    return plot.time == scene::PlotTime::kFilm ? filmTime_s : track.motionTime_s(filmTime_s);
  }

  void makeFrame() {
    const scene::QuantityUnit unit = track.quantity(0).unit;
    const std::string names = namesOf(track, plot.quantities.size());
    frame.title = plot.title;
    frame.y = plot.range ? givenAxis(unit, ranges.y, names, plot.unit, plot.range->low, plot.range->high)
                         : valueAxis(unit, ranges.y, names, plot.unit);
    if (!isPortrait()) {
      frame.x = timeAxis(shownTime_s(0), shownTime_s(track.duration_s()), "t");
      return;
    }
    const scene::StateQuantity& x = track.quantity(1);
    frame.x = valueAxis(x.unit, *ranges.x, track.tex(1), x.unit == unit ? plot.unit : "");
    frame.equalScales = x.unit == unit && frame.x.unit.perSi == frame.y.unit.perSi && ofLikeLength();
  }

  /// Returns false if the same scale for both axes would make the plot very narrow or very flat.
  bool ofLikeLength() const {
    const double ratio = (frame.x.high - frame.x.low) / (frame.y.high - frame.y.low);
    return ratio > 0.3 && ratio < 4;
  }

  double x(double filmTime_s, double portraitX) const {
    return frame.x.share(isPortrait() ? portraitX : shownTime_s(filmTime_s));
  }

  PlotPath curve(std::size_t which) const {
    std::vector<PlotPoint> all;
    for (std::size_t i = 0; i < track.samples(); ++i) {
      const double film_s = track.filmTime_s(i), across = isPortrait() ? track.sample(1, i) : 0;
      all.push_back({film_s, x(film_s, across), frame.y.share(track.sample(which, i))});
    }
    PlotPath path = finiteStretches(all);
    for (auto& stretch : path) stretch = bounded(isPortrait() ? stretch : perColumn(stretch, kColumns));
    return path;
  }

  PlotPoint cursor(std::size_t which, double filmTime_s) const {
    const double across = isPortrait() ? track.at(1, filmTime_s) : 0;
    return {filmTime_s, x(filmTime_s, across), frame.y.share(track.at(which, filmTime_s))};
  }

  std::vector<PlotValue> values(double filmTime_s) const;
  std::optional<ValueFormat> format(const PlotPen& pen) const;
  double type_px(const Sizing& sizing) const;
  PlotPen pen(const Sizing& sizing, glm::vec2 panel_px) const;
  double rightRoom(const PlotPen& pen) const;
  void addPath(draw::Picture& picture, const std::vector<PlotPoint>& points, const PixelBox& area,
               const draw::Color& color, const PlotPen& pen) const;
  void addCurves(draw::Picture& picture, const PixelBox& area, double filmTime_s, const PlotPen& pen) const;
  void addCursor(draw::Picture& picture, const PixelBox& area, double filmTime_s, const PlotPen& pen) const;
  void addPair(draw::Picture& picture, const PixelBox& panel, const PixelBox& area, double filmTime_s,
               const PlotPen& pen) const;
};

std::vector<PlotValue> PlotFigure::Plan::values(double filmTime_s) const {
  std::vector<PlotValue> all;
  if (!plot.cursor && plot.quantities.size() == 1) return all;  // the vertical axis names the only curve
  for (std::size_t i = 0; i < plot.quantities.size(); ++i) {
    const double end = curves[i].empty() ? 0 : curves[i].back().back().y;
    all.push_back({track.tex(i), tones[i], frame.y.unit.written(track.at(i, filmTime_s)), end});
  }
  return all;
}

/// Returns the format of the values beside the curves. Without a cursor, there are no values.
std::optional<ValueFormat> PlotFigure::Plan::format(const PlotPen& pen) const {
  return plot.cursor ? std::optional(valueFormat(frame.y, pen.decimalSign)) : std::nullopt;
}

double PlotFigure::Plan::rightRoom(const PlotPen& pen) const {
  return isPortrait() ? 0 : valuesWidth(values(0), format(pen), pen);
}

double PlotFigure::Plan::type_px(const Sizing& sizing) const {
  return style.textSize * smallSize_px(kType, sizing);
}

PlotPen PlotFigure::Plan::pen(const Sizing& sizing, glm::vec2 panel_px) const {
  PlotPen pen{colors, type_px(sizing), sizing.line_px * style.lineWidth, style.decimalSign};
  if (sizing.fixed_px > 0) pen.title = kFixedTitle;
  const PixelBox panel{0, 0, static_cast<double>(panel_px.x), static_cast<double>(panel_px.y)};
  const auto small = [&] {
    PlotFrame any = frame;
    any.equalScales = false;
    const PixelBox area = curveArea(panel, any, rightRoom(pen), pen);
    const double least = pen.em_px > sizing.least_px ? kLeastArea : kSmallestArea;
    return area.width() < least * panel.width() || area.height() < least * panel.height();
  };
  while (pen.em_px > sizing.floor_px && small()) pen.em_px = std::max(0.9 * pen.em_px, sizing.floor_px);
  return pen;
}

void PlotFigure::Plan::addPath(draw::Picture& picture, const std::vector<PlotPoint>& points, const PixelBox& area,
                               const draw::Color& color, const PlotPen& pen) const {
  const auto most = kPointsPerPixel * static_cast<std::size_t>(std::max(area.width(), 1.0));
  const bool dense = !isPortrait() && points.size() > most;
  for (const auto& stretch : insideBand(dense ? perColumn(points, static_cast<int>(area.width())) : points)) {
    if (stretch.size() < 2) continue;
    draw::Stroke stroke;
    for (const PlotPoint& p : stretch) stroke.points_px.emplace_back(glm::dvec2(area.x(p.x), area.y(p.y)));
    stroke.width_px = static_cast<float>(kCurve * pen.line_px);
    stroke.color = color;
    picture.strokes.push_back(std::move(stroke));
  }
}

void PlotFigure::Plan::addCurves(draw::Picture& picture, const PixelBox& area, double filmTime_s,
                                 const PlotPen& pen) const {
  // In a film that repeats, and without a cursor, the complete curve counts as travelled.
  const double travelled_s = repeats || !plot.cursor ? track.duration_s() : filmTime_s;
  std::vector<PlotPoint> at;
  for (std::size_t i = 0; i < curves.size(); ++i) at.push_back(cursor(i, travelled_s));
  for (std::size_t i = 0; plot.future && i < curves.size(); ++i)
    for (const auto& stretch : curves[i])
      addPath(picture, after(stretch, at[i]), area, glm::mix(tones[i], colors.paper, kFaint), pen);
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const auto& stretch : curves[i]) addPath(picture, before(stretch, at[i]), area, tones[i], pen);
}

void PlotFigure::Plan::addCursor(draw::Picture& picture, const PixelBox& area, double filmTime_s,
                                 const PlotPen& pen) const {
  // The dot is a circular stroke that is thick enough to have no hole, because only strokes can lie over strokes.
  constexpr int kCorners = 24;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const PlotPoint p = cursor(i, filmTime_s);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || p.y < 0 || p.y > 1) continue;
    const double radius = 0.5 * kCurveDot * pen.em_px;
    draw::Stroke dot;
    for (int k = 0; k < kCorners; ++k) {
      const double turn = 2 * std::numbers::pi * k / kCorners;
      dot.points_px.emplace_back(
          glm::dvec2(area.x(p.x) + radius * std::cos(turn), area.y(p.y) + radius * std::sin(turn)));
    }
    dot.closed = true;
    dot.width_px = static_cast<float>(2 * radius);
    dot.color = tones[i];
    picture.strokes.push_back(std::move(dot));
  }
}

// Writes the current values of both quantities of a phase portrait at the right, above the curves.
void PlotFigure::Plan::addPair(draw::Picture& picture, const PixelBox& panel, const PixelBox& area,
                               double filmTime_s, const PlotPen& pen) const {
  const double em = pen.em_px, baseline = labelRow(area, pen);
  double right = panel.right - kPlotEdge * em;
  const double least = labelLeft(area, frame, pen) + widthOf(frame.y.label, em) + em;
  const PlotAxis* axes[] = {&frame.y, &frame.x};
  for (const std::size_t which : {0u, 1u}) {
    const ValueFormat format = valueFormat(*axes[which], pen.decimalSign);
    const std::string name = "$" + track.tex(which) + "\\,=$";
    const double left = right - (format.width_em + 0.3) * em - widthOf(name, em);
    if (left < least) return;
    const double value = axes[which]->unit.written(track.at(which, filmTime_s));
    addLine(picture, name, left, baseline, Align::kLeft, em, tones[0]);
    addLine(picture, numberTex(fixedDigits(value, format.decimals), pen.decimalSign), right, baseline,
            Align::kRight, em, tones[0]);
    right = left - em;
  }
}

PlotFigure::PlotFigure(const scene::Scene& scene, const scene::Plot& plot,
                       std::shared_ptr<const physics::Motion> motion, const std::optional<PlotRanges>& least)
    : plan_(std::make_unique<Plan>(scene, plot, std::move(motion), least)) {}
PlotFigure::~PlotFigure() = default;
PlotFigure::PlotFigure(PlotFigure&&) noexcept = default;

const PlotRanges& PlotFigure::ranges() const { return plan_->ranges; }

double PlotFigure::typeShare(const Cell& cell, const Sizing& sizing) const {
  return plan_->pen(sizing, cell.size_px).em_px / plan_->type_px(sizing);
}

PlotSides PlotFigure::sides(const Cell& cell, const Sizing& sizing) const {
  if (plan_->isPortrait()) return {};
  const PlotPen pen = plan_->pen(sizing, cell.size_px);
  const PixelBox panel{0, 0, static_cast<double>(cell.size_px.x), static_cast<double>(cell.size_px.y)};
  const PixelBox area = curveArea(panel, plan_->frame, plan_->rightRoom(pen), pen);
  return {area.left, panel.right - area.right};
}

void PlotFigure::add(draw::Picture& picture, const Cell& cell, const Sizing& sizing, double filmTime_s,
                     const PlotSides& least) const {
  const Plan& plan = *plan_;
  const PlotPen pen = plan.pen(sizing, cell.size_px);
  const glm::dvec2 corner(cell.origin_px), far = corner + glm::dvec2(cell.size_px);
  const PixelBox panel{corner.x, corner.y, far.x, far.y};
  PixelBox area = curveArea(panel, plan.frame, plan.rightRoom(pen), pen);
  if (!plan.isPortrait()) {
    area.left = std::max(area.left, panel.left + least.left);
    area.right = std::min(area.right, panel.right - least.right);
  }
  addFrame(picture, panel, area, fitted(plan.frame, area, pen), pen);
  if (plan.plot.cursor && !plan.isPortrait()) {
    draw::Stroke line;
    const auto x = static_cast<float>(area.x(plan.x(filmTime_s, 0)));
    line.points_px = {{x, static_cast<float>(area.top)}, {x, static_cast<float>(area.bottom)}};
    line.width_px = static_cast<float>(kCursor * pen.line_px);
    line.color = plan.colors.quietInk;
    picture.strokes.push_back(std::move(line));
  }
  plan.addCurves(picture, area, filmTime_s, pen);
  if (plan.plot.cursor) plan.addCursor(picture, area, filmTime_s, pen);
  if (!plan.isPortrait())
    addValues(picture, panel, area, plan.values(filmTime_s), plan.format(pen), pen);
  else if (plan.plot.cursor)
    plan.addPair(picture, panel, area, filmTime_s, pen);
}

}  // namespace poinsot::stage
