// SPDX-License-Identifier: Apache-2.0
// Read-outs, compared with numbers worked out by hand from the lecture's formulas.
#include "stage/type/readout_board.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_samples.h"
#include "stage/picture_motion.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

using scene::QuantityUnit;

// Returns a symmetric top with I = (1.5, 1.5, 0.9) kg·m² and omega = (0.5, 0, 2) rad/s: |L| = 1.95, 2T = 3.975,
// theta = atan2(0.75, 1.8). In the body, omega goes round at Omega_p = (I3/I1 - 1) omega_3 = -0.8 rad/s (lecture,
// eq 29).
scene::Scene top(const std::string& more) {
  return scene::parseScene(
      "[body]\nprincipal_moments = [1.5, 1.5, 0.9]\n[motion]\nomega_body = [0.5, 0, 2]\n[time]\nduration = 10\n"
      "speed = 1\n" +
          more,
      "top.toml");
}

const std::string kFive =
    "[[readout]]\nquantity = \"t\"\n[[readout]]\nquantity = \"omega_1\"\n[[readout]]\nquantity = \"theta\"\n"
    "[[readout]]\nquantity = \"L\"\nat = \"bottom\"\n[[readout]]\nquantity = \"h\"\nlabel = \"height\"\n";

std::vector<ReadoutText> textsAt(const scene::Scene& scene, double filmTime_s) {
  return ReadoutBoard(scene, drawnMotion(scene), palette(scene.style.theme)).at(filmTime_s);
}

double widthOf(const std::string& tex) { return text::setTex(tex).width_em; }

TEST(Readouts, ShowTheQuantitiesAtTheTimeOfThePicture) {
  const auto texts = textsAt(top(kFive), 3.7);
  ASSERT_EQ(texts.size(), 5u);
  EXPECT_EQ(texts[0].name + texts[0].value + texts[0].unit, "$t\\,=$$3.70$$\\,\\mathrm{s}$");
  EXPECT_EQ(texts[1].value, "$-0.492$");  // 0.5 cos(0.8 · 3.7) = -0.49176
  EXPECT_EQ(texts[2].value, "$22.62$");   // atan2(0.75, 1.8) = 22.61986 degrees
  EXPECT_EQ(texts[2].unit, "$\\degree$");
  EXPECT_EQ(texts[3].value, "$1.950$");
  EXPECT_EQ(texts[3].at, scene::Spot::kBottom);
  EXPECT_EQ(texts[4].name, "height $=$");
  EXPECT_EQ(texts[4].value, "$2.038$");  // 3.975/1.95 = 2.03846
  EXPECT_EQ(textsAt(top(kFive), 0)[1].value, "$0.500$");
}

TEST(Readouts, KeepTheirWidthThroughoutTheFilm) {
  const ReadoutBoard board(top(kFive), drawnMotion(top(kFive)), palette(scene::Theme::kLight));
  const auto first = board.at(0);
  bool signs = false;
  for (double t = 0; t <= 10; t += 0.05) {
    const auto now = board.at(t);
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_EQ(now[i].widest, first[i].widest);
      EXPECT_LE(widthOf(now[i].value), widthOf(now[i].widest) + 1e-12) << now[i].value;
      signs = signs || now[i].value.starts_with("$-");
    }
  }
  EXPECT_TRUE(signs);
  EXPECT_EQ(first[1].widest, "$-0.500$");
  EXPECT_EQ(widthOf("$1.11$"), widthOf("$8.88$"));
}

TEST(Readouts, WriteTheDecimalSignOfTheStyle) {
  for (const ReadoutText& text : textsAt(top(kFive + "[style]\ndecimal_sign = \"comma\"\n"), 3.7))
    EXPECT_EQ((text.value + text.widest).find('.'), std::string::npos) << text.value;
}

std::string written(QuantityUnit unit, const QuantityRange& range, double si) {
  const ReadoutFormat format = readoutFormat(unit, range);
  return format.tex(si, scene::DecimalSign::kPoint) + unitSuffix(format.unit);
}

// A value has enough decimals for a few hundred steps over the film, or four digits if it stands still, but at
// most four digits.
TEST(Readouts, HaveAsManyDecimalsAsTheFilmNeeds) {
  EXPECT_EQ(written(QuantityUnit::kSecond, {0, 60, 1}, 12.345), "$12.3$$\\,\\mathrm{s}$");
  EXPECT_EQ(written(QuantityUnit::kAngle, {0, 6.28, 1}, 1), "$57$$\\degree$");
  EXPECT_EQ(written(QuantityUnit::kAngle, {0.5, 0.5001, 1}, 0.5), "$28.65$$\\degree$");
  EXPECT_EQ(written(QuantityUnit::kJoule, {2.3456e5, 2.3456e5, 2e5}, 2.3456e5),
            "$234.6$$\\,\\times\\,10^{3}\\,\\mathrm{J}$");
  EXPECT_EQ(written(QuantityUnit::kRadianPerSecond, {-1e-17, 1e-17, 2}, -1e-17), "$0.000$$\\,\\mathrm{rad/s}$");
  EXPECT_EQ(written(QuantityUnit::kJoule, {0, 0, 0}, 0), "$0.000$$\\,\\mathrm{J}$");
  EXPECT_EQ(written(QuantityUnit::kAngle, {0, 1, 1}, std::nan("")), "$--$$\\degree$");
}

// omega_3 is 2 rad/s all along; alone, it would have four digits.
TEST(Readouts, HaveAsManyDecimalsAsOtherCellsNeed) {
  const scene::Scene scene = top("[[readout]]\nquantity = \"omega_3\"\n");
  const QuantityRange others[] = {{0, 60, 60}};
  const ReadoutBoard board(scene, drawnMotion(scene), palette(scene.style.theme), others);
  EXPECT_EQ(textsAt(scene, 1).at(0).value, "$2.000$");
  EXPECT_EQ(board.at(1).at(0).value, "$2.0$");
  EXPECT_EQ(board.at(1).at(0).widest, "$60.0$");
  EXPECT_EQ(board.ranges().at(0).high, 60);
}

// A spin of 1 rad/s is 30/pi turns a minute. A requested unit has no power of ten.
TEST(Readouts, UseTheRequestedUnit) {
  const auto inUnit = [](QuantityUnit unit, const QuantityRange& range, const std::string& asked, double si) {
    const ReadoutFormat format = readoutFormat(unit, range, asked);
    return format.tex(si, scene::DecimalSign::kPoint) + unitSuffix(format.unit);
  };
  EXPECT_EQ(inUnit(QuantityUnit::kRadianPerSecond, {1, 1, 1}, "rpm", 1), "$9.549$$\\,\\mathrm{rpm}$");
  EXPECT_EQ(inUnit(QuantityUnit::kRadianPerSecond, {2e5, 2e5, 2e5}, "rad/s", 2e5), "$200000$$\\,\\mathrm{rad/s}$");
  EXPECT_EQ(inUnit(QuantityUnit::kAngle, {0.5, 0.5, 1}, "rad", 0.5), "$0.5000$$\\,\\mathrm{rad}$");
  EXPECT_EQ(inUnit(QuantityUnit::kAngle, {0.5, 0.5, 1}, "deg", 0.5), "$28.65$$\\degree$");
  EXPECT_EQ(inUnit(QuantityUnit::kAction, {0.25, 0.25, 0.25}, "g m^2/s", 0.25), "$250.0$$\\,\\mathrm{g\\,m^2/s}$");
  EXPECT_EQ(textsAt(top("[[readout]]\nquantity = \"omega_3\"\nunit = \"deg/s\"\n"), 0).at(0).unit,
            "$\\,\\mathrm{deg/s}$");
}

}  // namespace
}  // namespace poinsot::stage
