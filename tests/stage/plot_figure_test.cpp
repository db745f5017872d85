// SPDX-License-Identifier: Apache-2.0
// Plots without pixels: the places of curves, dots and type.
#include "stage/plot/plot_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ink.h"
#include "scene/state_quantity.h"
#include "scene_samples.h"
#include "stage/picture_motion.h"
#include "stage/plot/plot_tones.h"
#include "stage/plot/plot_values.h"

namespace poinsot::stage {
namespace {

constexpr glm::ivec2 kOrigin{960, 40}, kSize{900, 500};

int indexOf(std::string_view name) {
  const auto all = scene::stateQuantities();
  return static_cast<int>(std::ranges::find(all, name, &scene::StateQuantity::name) - all.begin());
}

scene::Plot plotOf(const std::vector<const char*>& names) {
  scene::Plot plot;
  for (const char* name : names) plot.quantities.push_back(indexOf(name));
  return plot;
}

draw::Picture drawn(const scene::Scene& scene, const scene::Plot& plot, double filmTime_s,
                    glm::ivec2 size = kSize) {
  draw::Picture picture;
  picture.size_px = {1920, 1080};
  PlotFigure(scene, plot, drawnMotion(scene))
      .add(picture, {kOrigin, size}, screenSizing(picture.size_px), filmTime_s);
  return picture;
}

std::vector<const draw::Text*> textsWith(const draw::Picture& picture, const std::string& tex) {
  std::vector<const draw::Text*> found;
  for (const draw::Text& text : picture.texts)
    if (text.tex == tex) found.push_back(&text);
  return found;
}

/// Returns the strokes of a colour that are not dots.
std::vector<const draw::Stroke*> lines(const draw::Picture& picture, const draw::Color& color) {
  std::vector<const draw::Stroke*> found;
  for (const draw::Stroke& stroke : picture.strokes)
    if (stroke.color == color && !stroke.closed) found.push_back(&stroke);
  return found;
}

glm::vec2 middleOf(const draw::Stroke& dot) {
  glm::vec2 sum(0);
  for (const glm::vec2& p : dot.points_px) sum += p;
  return sum / static_cast<float>(dot.points_px.size());
}

std::vector<glm::vec2> dots(const draw::Picture& picture) {
  std::vector<glm::vec2> all;
  for (const draw::Stroke& stroke : picture.strokes)
    if (stroke.closed) all.push_back(middleOf(stroke));
  return all;
}

void expectInside(const draw::Picture& picture, glm::ivec2 size = kSize) {
  const glm::vec2 low(kOrigin), high = low + glm::vec2(size);
  for (const draw::Stroke& stroke : picture.strokes)
    for (const glm::vec2& p : stroke.points_px) {
      const float half = 0.5f * stroke.width_px;
      ASSERT_TRUE(p.x - half >= low.x && p.y - half >= low.y && p.x + half <= high.x && p.y + half <= high.y)
          << p.x << ", " << p.y;
    }
  const PixelBox panel{low.x, low.y, high.x, high.y};
  for (const draw::Text& text : picture.texts) {
    const PixelBox ink = inkOf(text);
    EXPECT_TRUE(ink.left >= panel.left && ink.top >= panel.top && ink.right <= panel.right &&
                ink.bottom <= panel.bottom)
        << text.tex << " at " << ink.left << ", " << ink.top << " to " << ink.right << ", " << ink.bottom;
  }
}

void expectDisjoint(const draw::Picture& picture) {
  for (std::size_t i = 0; i < picture.texts.size(); ++i)
    for (std::size_t j = i + 1; j < picture.texts.size(); ++j) {
      const PixelBox a = inkOf(picture.texts[i]), b = inkOf(picture.texts[j]);
      EXPECT_TRUE(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top)
          << picture.texts[i].tex << " and " << picture.texts[j].tex;
    }
}

// Places of values in the picture, derived from the labels of two ticks on each axis.
struct Axes {
  double x0, perX, y0, perY;

  glm::dvec2 place(double x, double y) const { return {x0 + perX * x, y0 + perY * y}; }
};

double middleX(const draw::Text& text) { return 0.5 * (inkOf(text).left + inkOf(text).right); }
double middleY(const draw::Text& text) { return 0.5 * (inkOf(text).top + inkOf(text).bottom); }

/// Returns the axes of a plot.
/// @param x0,x1  labels of two ticks below the plot, which are `dx` apart
/// @param y0,y1  labels of the ticks yLow and yHigh at the left
Axes axesOf(const draw::Picture& picture, const char* x0, const char* x1, double dx, const char* y0,
            const char* y1, double yLow, double yHigh) {
  const double left = middleX(*textsWith(picture, x0).at(0)), right = middleX(*textsWith(picture, x1).at(0));
  const double low = middleY(*textsWith(picture, y0).at(0)), high = middleY(*textsWith(picture, y1).at(0));
  const double perY = (high - low) / (yHigh - yLow);
  return {left, (right - left) / dx, low - perY * yLow, perY};
}

const char* kTenSeconds = "[time]\nduration = 10\nspeed = 1\n";

TEST(PlotFigure, CurvesAndDotsMatchTheQuantity) {
  const scene::Scene scene = sample(kTenSeconds);
  const scene::Plot plot = plotOf({"omega_1", "omega_2", "omega_3"});
  const auto motion = drawnMotion(scene);
  const double now = 3.7;
  const draw::Picture picture = drawn(scene, plot, now);
  const Axes axes = axesOf(picture, "$2$", "$8$", 6, "$-1$", "$1$", -1, 1);
  const double zero = axes.x0 - 2 * axes.perX;
  const auto tones = quantityColors(palette(scene.style.theme), plot.quantities);
  for (int which = 0; which < 3; ++which) {
    const auto place = [&](double t) {
      return glm::dvec2(zero + axes.perX * t, axes.place(0, motion->at(t).omega_B[which]).y);
    };
    const auto past = lines(picture, tones[static_cast<std::size_t>(which)]);
    ASSERT_EQ(past.size(), 1u);
    double worst = 0;
    for (const glm::vec2& p : past[0]->points_px) {
      const double t = (static_cast<double>(p.x) - zero) / axes.perX;
      worst = std::max(worst, std::abs(static_cast<double>(p.y) - place(std::clamp(t, 0.0, 10.0)).y));
    }
    EXPECT_LE(worst, 0.7);  // measured 0.4; the ink of a label gives the tick's place to half a pixel
    const glm::dvec2 dot(dots(picture).at(static_cast<std::size_t>(which)));
    EXPECT_NEAR(dot.x, place(now).x, 0.7);
    EXPECT_NEAR(dot.y, place(now).y, 0.7);
    EXPECT_NEAR(past[0]->points_px.back().x, dot.x, 1e-2);  // the past ends in the dot
    EXPECT_NEAR(past[0]->points_px.back().y, dot.y, 1e-2);
  }
}

TEST(PlotFigure, TheCursorIsAtTheTimeOfThePicture) {
  const scene::Scene scene = sample(kTenSeconds);
  const scene::Plot plot = plotOf({"T"});
  for (const double now : {0.0, 2.5, 10.0}) {
    const draw::Picture picture = drawn(scene, plot, now);
    const double x2 = middleX(*textsWith(picture, "$2$").at(0)), x8 = middleX(*textsWith(picture, "$8$").at(0));
    const double wanted = x2 + (x8 - x2) * (now - 2) / 6;
    EXPECT_NEAR(static_cast<double>(dots(picture).at(0).x), wanted, 0.7) << now;
    const bool line = std::ranges::any_of(picture.strokes, [&](const draw::Stroke& s) {
      return s.points_px.size() == 2 && s.points_px[0].x == s.points_px[1].x &&
             std::abs(static_cast<double>(s.points_px[0].x) - wanted) < 0.7 &&
             std::abs(s.points_px[0].y - s.points_px[1].y) > 200;
    });
    EXPECT_TRUE(line) << now;
  }
}

TEST(PlotFigure, StaysInsideItsPanelWithoutOverlappingLabels) {
  const scene::Scene free = sample(kTenSeconds);
  const scene::Scene earth = scene::parseScene(
      "[body]\nprincipal_moments = [8.01e37, 8.01e37, 8.034e37]\n[motion]\nomega_body = [3e-10, 0, 7.292e-5]\n"
      "[time]\nduration = 20\nspeed = 3e6\n",
      "earth.toml");
  const std::vector<std::vector<const char*>> choices = {{"omega_1", "omega_2", "omega_3"},
                                                         {"omega_x", "omega_y", "omega_z", "omega", "h", "rho"},
                                                         {"T", "E", "V"},
                                                         {"theta", "phi", "psi"},
                                                         {"L_x", "L_y", "L_z"},
                                                         {"q_w", "q_x", "q_y", "q_z"},
                                                         {"t"},
                                                         {"L"}};
  for (const scene::Scene& scene : {free, earth})
    for (const auto& names : choices)
      for (const glm::ivec2 size : {kSize, glm::ivec2(500, 300), glm::ivec2(320, 900)})
        for (const double now : {0.0, 3.3, 10.0}) {
          scene::Plot plot = plotOf(names);
          plot.title = "A title";
          SCOPED_TRACE(testing::Message() << names[0] << ' ' << size.x << " of " << scene.name << " at " << now);
          const draw::Picture picture = drawn(scene, plot, now, size);
          expectInside(picture, size);
          expectDisjoint(picture);
        }
}

TEST(PlotFigure, ClipsCurvesToAGivenRange) {
  const scene::Scene scene = sample(kTenSeconds);
  scene::Plot plot = plotOf({"omega_1", "omega_2"});
  plot.range = scene::PlotRange{0, 0.4};
  const draw::Picture picture = drawn(scene, plot, 5);
  expectInside(picture);
  const double top = middleY(*textsWith(picture, "$0.4$").at(0)),
               bottom = middleY(*textsWith(picture, "$0.0$").at(0));
  const auto tones = quantityColors(palette(scene.style.theme), plot.quantities);
  EXPECT_GT(lines(picture, tones[0]).size() + lines(picture, tones[1]).size(), 2u);
  for (const draw::Color& tone : tones)
    for (const draw::Stroke* stroke : lines(picture, tone))
      for (const glm::vec2& p : stroke->points_px) {
        EXPECT_GE(static_cast<double>(p.y), top - 1);
        EXPECT_LE(static_cast<double>(p.y), bottom + 1);
      }
}

TEST(PlotFigure, DrawsTheFutureUnlessTheSceneTurnsItOff) {
  const scene::Scene scene = sample(kTenSeconds);
  scene::Plot plot = plotOf({"omega_1"});
  const auto count = [&](double now) { return drawn(scene, plot, now).strokes.size(); };
  const std::size_t with = count(5);
  plot.future = false;
  EXPECT_EQ(count(5), with - 1);
  EXPECT_EQ(count(10), with - 1);  // nothing is left to come
}

// The polhode is closed (eq 38, 39). Its projection on two principal axes is an ellipse with I1 (I3 - I1) omega_1²
// + I2 (I3 - I2) omega_2² = 2 T I3 - L² (PHYSICS 2.2). The ratio of its axes is therefore sqrt(I2 (I3 - I2)/(I1
// (I3 - I1))).
TEST(PlotFigure, APhasePortraitOfAFreeBodyIsAClosedEllipse) {
  const scene::Scene scene = scene::parseScene(
      "[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [0.5, 0.25, 1]\n[time]\n"
      "duration = 11.18295442677762\nspeed = 1\n",
      "p1.toml");  // PHYSICS 2.11, P1: the period of the polhode
  scene::Plot plot = plotOf({"omega_2"});
  plot.x = indexOf("omega_1");
  const draw::Picture picture = drawn(scene, plot, scene.time.duration_s);
  expectInside(picture);
  expectDisjoint(picture);
  const auto curve = lines(picture, quantityColors(palette(scene.style.theme), plot.quantities)[0]);
  ASSERT_EQ(curve.size(), 1u);
  const auto& points = curve[0]->points_px;
  EXPECT_NEAR(points.front().x, points.back().x, 2e-3);  // measured 0 px
  EXPECT_NEAR(points.front().y, points.back().y, 2e-3);
  const auto [left, right] = std::ranges::minmax(points, {}, &glm::vec2::x);
  const auto [top, bottom] = std::ranges::minmax(points, {}, &glm::vec2::y);
  const double ratio = static_cast<double>((right.x - left.x) / (bottom.y - top.y));
  EXPECT_NEAR(ratio, std::sqrt(3 * 1.0 / (2 * 2.0)), 1e-3);  // one scale on both axes
}

TEST(PlotFigure, AnHourOfFilmIsDrawnWithABoundedNumberOfPoints) {
  for (const char* more : {"speed = 1\n", "speed = 500\n"}) {
    const scene::Scene scene = sample(std::string("[time]\nduration = 3600\nfps = 10\n") + more);
    scene::Plot series = plotOf({"omega_1", "phi"}), portrait = plotOf({"omega_2"});
    series.quantities.pop_back();
    portrait.x = indexOf("omega_1");
    for (const scene::Plot& plot : {series, portrait}) {
      const draw::Picture picture = drawn(scene, plot, 1800);
      std::size_t points = 0;
      for (const draw::Stroke& stroke : picture.strokes) points += stroke.points_px.size();
      EXPECT_LE(points, 21'000u);
      expectInside(picture);
    }
  }
}

TEST(PlotFigure, ValuesDoNotJitter) {
  const scene::Scene scene = sample(kTenSeconds);
  const scene::Plot plot = plotOf({"omega_1", "omega_2", "omega_3"});
  const draw::Picture first = drawn(scene, plot, 0), later = drawn(scene, plot, 6.1);
  ASSERT_EQ(first.texts.size(), later.texts.size());
  const auto right = [](const draw::Text& t) {
    return static_cast<double>(t.baseline_px.x) + text::setTex(t.tex).width_em * static_cast<double>(t.size_px);
  };
  int values = 0;
  for (std::size_t i = 0; i < first.texts.size(); ++i) {
    EXPECT_EQ(first.texts[i].baseline_px.y, later.texts[i].baseline_px.y);
    EXPECT_NEAR(right(first.texts[i]), right(later.texts[i]), 1e-3);
    values += first.texts[i].tex != later.texts[i].tex;
  }
  EXPECT_EQ(values, 3);
}

TEST(PlotFigure, WithoutACursorTheWholeCurveIsStrong) {
  const scene::Scene scene = sample(kTenSeconds);
  scene::Plot plot = plotOf({"omega_1"});
  const auto tone = quantityColors(palette(scene.style.theme), plot.quantities).at(0);
  const draw::Picture marked = drawn(scene, plot, 2);
  plot.cursor = false;
  const draw::Picture plain = drawn(scene, plot, 2), later = drawn(scene, plot, 9);
  EXPECT_TRUE(dots(plain).empty());
  EXPECT_EQ(marked.strokes.size() - plain.strokes.size(),
            3u);  // the line, the dot and the faint part of the curve
  const auto curve = lines(plain, tone);
  ASSERT_EQ(curve.size(), 1u);
  const double at2 = middleX(*textsWith(plain, "$2$").at(0)), at8 = middleX(*textsWith(plain, "$8$").at(0));
  EXPECT_NEAR(curve[0]->points_px.front().x, at2 - (at8 - at2) / 3, 1);  // 0 s
  EXPECT_NEAR(curve[0]->points_px.back().x, at8 + (at8 - at2) / 3, 1);   // 10 s
  for (const draw::Text& text : plain.texts) EXPECT_EQ(text.tex.find("="), std::string::npos) << text.tex;
  ASSERT_EQ(plain.strokes.size(), later.strokes.size());
  for (std::size_t i = 0; i < plain.strokes.size(); ++i)
    EXPECT_EQ(plain.strokes[i].points_px, later.strokes[i].points_px);
  expectInside(plain);
  expectDisjoint(plain);
}

TEST(PlotFigure, WithoutACursorSeveralCurvesKeepTheirNames) {
  const scene::Scene scene = sample(kTenSeconds);
  scene::Plot plot = plotOf({"omega_1", "omega_2"}), portrait = plotOf({"omega_2"});
  plot.cursor = portrait.cursor = false;
  portrait.x = indexOf("omega_1");
  const draw::Picture picture = drawn(scene, plot, 2);
  EXPECT_EQ(textsWith(picture, "$\\omega_1$").size(), 1u);
  EXPECT_EQ(textsWith(picture, "$\\omega_2$").size(), 1u);
  expectInside(picture);
  expectDisjoint(picture);
  const draw::Picture phase = drawn(scene, portrait, 2);
  EXPECT_TRUE(dots(phase).empty());
  for (const draw::Text& text : phase.texts) EXPECT_EQ(text.tex.find("="), std::string::npos) << text.tex;
}

TEST(PlotFigure, WritesTheDecimalSignOfTheStyle) {
  scene::Scene scene = sample(kTenSeconds);
  scene.style.decimalSign = scene::DecimalSign::kComma;
  const draw::Picture picture = drawn(scene, plotOf({"omega_1"}), 1);
  for (const draw::Text& text : picture.texts) EXPECT_EQ(text.tex.find('.'), std::string::npos) << text.tex;
  // The comma is as wide as a point, because it is a decimal sign and not punctuation.
  EXPECT_NEAR(text::setTex("$1{,}5$").width_em, text::setTex("$1.5$").width_em, 1e-9);
}

TEST(PlotValues, AreSpreadInTheirOrder) {
  const std::vector<double> wanted = {5, 5, 0, 9.5, 9.9};
  const std::vector<double> places = spread(wanted, 1, 0, 10);
  std::vector<double> sorted = places;
  std::ranges::sort(sorted);
  for (std::size_t i = 1; i < sorted.size(); ++i) EXPECT_GE(sorted[i] - sorted[i - 1], 1 - 1e-12);
  EXPECT_GE(sorted.front(), 0);
  EXPECT_LE(sorted.back(), 10);
  EXPECT_EQ(places[2], 0);
  EXPECT_LT(places[0], places[1]);
  EXPECT_LT(places[3], places[4]);
}

}  // namespace
}  // namespace poinsot::stage
