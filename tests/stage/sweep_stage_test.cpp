// SPDX-License-Identifier: Apache-2.0
// Small multiples as values: the places of cells and labels, and what cells have in common.
#include "stage/sweep_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "ink.h"
#include "scene_samples.h"

namespace poinsot::stage {
namespace {

struct Made {
  std::vector<scene::SweepAxis> axes;
  SweepStage stage;
};

/// Returns the sample with -D words, one or two of which are ranges.
Made swept(const std::string& extra, const std::vector<std::string>& words, int columns = 0) {
  std::vector<scene::SweepAxis> axes;
  for (const std::string& word : words) axes.push_back(scene::sweepAxis(word).value());
  std::vector<scene::Scene> cells;
  for (std::size_t row = 0; row < (axes.size() == 2 ? axes[1].values.size() : 1); ++row)
    for (std::size_t column = 0; column < axes[0].values.size(); ++column) {
      std::vector<std::string> overrides{axes[0].override(column)};
      if (axes.size() == 2) overrides.push_back(axes[1].override(row));
      cells.push_back(
          scene::parseScene("[body]\nshape = 'box'\nsize = [3, 2, 1]\nmass = 1\n[time]\nduration = 10\nspeed = "
                            "1\n[motion]\nomega_body = [1, 0.5, 1.6]\n" +
                                extra,
                            "sample.toml", overrides));
    }
  auto labels = sweepLabels(axes, {}, cells[0]);
  const bool instants = std::ranges::any_of(axes, &scene::SweepAxis::variesInstant);
  return {axes, SweepStage(std::move(cells), std::move(labels), columns,
                           instants ? CellTime::kOfScene : CellTime::kOfPicture)};
}

const std::string kWritten =
    "[[note]]\ntext = 'A note'\n[[timeline]]\nat = 0\ncaption = 'A caption'\n"
    "[show]\ntitle = 'A title'\nsubtitle = 'of two lines'\n";
const std::vector<std::string> kOne{"motion.omega_body=[0.1..0.5:5, 1, 0]"};
const std::vector<std::string> kTwo{"motion.omega_body=[0.1..0.5:3, 1, 0]", "camera.azimuth=0..30 deg:2"};
constexpr glm::ivec2 kSizes[] = {{1280, 720}, {961, 541}, {500, 800}, {160, 90}, {16, 16}};

TEST(SweepStage, CellsHaveOneSizeAndDoNotOverlap) {
  for (const std::string& extra : {std::string(), kWritten})
    for (const auto& words : {kOne, kTwo})
      for (const glm::ivec2 size : kSizes) {
        SCOPED_TRACE(testing::Message() << size.x << "x" << size.y << " " << words.size() << " " << extra.size());
        const draw::Picture picture = swept(extra, words).stage.compose(2, size);
        ASSERT_EQ(picture.panels.size(), words.size() == 1 ? 5u : 6u);
        const auto sizeOf = [](const draw::Panel& p) { return glm::ivec2(p.list.camera.size_px); };
        for (const draw::Panel& panel : picture.panels) {
          EXPECT_EQ(sizeOf(panel), sizeOf(picture.panels[0]));
          const glm::ivec2 low = panel.origin_px, high = low + sizeOf(panel);
          EXPECT_TRUE(low.x >= 0 && low.y >= 0 && high.x <= size.x && high.y <= size.y) << low.x << " " << low.y;
          for (const draw::Panel& other : picture.panels) {
            if (&other == &panel) break;
            const glm::ivec2 from = other.origin_px, to = from + sizeOf(other);
            EXPECT_TRUE(to.x <= low.x || high.x <= from.x || to.y <= low.y || high.y <= from.y);
          }
        }
      }
}

TEST(SweepStage, TextsAreInsideThePictureAndOutsideTheCells) {
  for (const auto& words : {kOne, kTwo})
    for (const glm::ivec2 size : {kSizes[0], kSizes[1], kSizes[2]}) {
      const draw::Picture picture = swept(kWritten, words).stage.compose(2, size);
      EXPECT_GE(picture.texts.size(), 4 + 5u);  // title, subtitle, note, caption; labels
      for (const draw::Text& text : picture.texts) {
        const PixelBox ink = inkOf(text);
        EXPECT_TRUE(ink.left >= 0 && ink.top >= 0 && ink.right <= size.x && ink.bottom <= size.y) << text.tex;
        for (const draw::Panel& panel : picture.panels) {
          const glm::dvec2 low(panel.origin_px), high = low + glm::dvec2(panel.list.camera.size_px);
          EXPECT_FALSE(near(ink, {low.x, low.y, high.x, high.y})) << text.tex;
        }
        for (const draw::Text& other : picture.texts) {
          if (&other == &text) break;
          EXPECT_FALSE(near(ink, inkOf(other))) << text.tex << " and " << other.tex;
        }
      }
    }
}

TEST(SweepStage, EachValueIsWrittenAtItsCells) {
  const auto baseline = [](const draw::Picture& picture, const std::string& tex) {
    const auto found = std::ranges::find(picture.texts, tex, &draw::Text::tex);
    if (found == picture.texts.end()) ADD_FAILURE() << tex;
    return found == picture.texts.end() ? glm::vec2(0) : found->baseline_px;
  };
  const draw::Picture one = swept("", kOne).stage.compose(2, {1280, 720});
  for (int i = 0; i < 5; ++i) {
    const draw::Panel& cell = one.panels[static_cast<std::size_t>(i)];
    const glm::vec2 at = baseline(one, "$\\omega_1 = 0." + std::to_string(i + 1) + "\\,\\mathrm{rad/s}$");
    EXPECT_TRUE(at.x > cell.origin_px.x && at.x < cell.origin_px.x + cell.list.camera.size_px.x) << i;
    EXPECT_TRUE(at.y < cell.origin_px.y && at.y > cell.origin_px.y - 60) << i;
  }
  const draw::Picture two = swept("", kTwo).stage.compose(2, {1280, 720});
  for (int row = 0; row < 2; ++row) {
    const draw::Panel& cell = two.panels[static_cast<std::size_t>(3 * row)];
    const glm::vec2 at = baseline(two, row == 0 ? "azimuth $= 0\\degree$" : "azimuth $= 30\\degree$");
    EXPECT_LT(at.x, cell.origin_px.x);
    EXPECT_TRUE(at.y > cell.origin_px.y && at.y < cell.origin_px.y + cell.list.camera.size_px.y);
  }
}

TEST(SweepStage, TitleNotesAndCaptionsAppearOnce) {
  const draw::Picture picture = swept(kWritten, kOne).stage.compose(2, {1280, 720});
  const auto count = [&](const std::string& tex) {
    return std::ranges::count(picture.texts, tex, &draw::Text::tex);
  };
  EXPECT_EQ(count("\\textbf{A title}"), 1);
  EXPECT_EQ(count("of two lines"), 1);
  EXPECT_EQ(count("A note"), 1);
  EXPECT_EQ(count("A caption"), 1);
}

TEST(SweepStage, ACellShowsThePictureOfItsScene) {
  const Made made = swept("", kOne);
  const draw::Picture picture = made.stage.compose(3.3, {1280, 720});
  std::set<float> directions;
  for (std::size_t i = 0; i < 5; ++i) {
    const draw::DrawList& cell = picture.panels[i].list;
    const auto scene = scene::parseScene(
        "[body]\nshape = 'box'\nsize = [3, 2, 1]\nmass = 1\n[time]\nduration = 10\nspeed = 1\n[motion]\n",
        "sample.toml", {made.axes[0].override(i)});
    const draw::DrawList alone = onlyList(Stage(scene), 3.3, glm::ivec2(cell.camera.size_px));
    ASSERT_EQ(cell.boxes.size(), alone.boxes.size());
    ASSERT_FALSE(cell.boxes.empty());
    EXPECT_EQ(cell.boxes[0].halfAxes_V, alone.boxes[0].halfAxes_V) << i;
    directions.insert(cell.boxes[0].halfAxes_V[0].x);
  }
  EXPECT_EQ(directions.size(), 5u);  // five motions
}

// The box is as large in all cells; measured as half its longest edge in pixels, across the view at its centre.
TEST(SweepStage, BodiesHaveTheSameScaleInAllCells) {
  const draw::Picture picture = swept("", kOne).stage.compose(0, {1280, 720});
  const auto edge_px = [](const draw::DrawList& list) {
    const draw::Box& box = list.boxes.at(0);
    const float depth = draw::depthOf(list.camera, box.centre_V);
    return static_cast<double>(glm::length(box.halfAxes_V[0]) * list.camera.scale_px(depth));
  };
  const double first = edge_px(picture.panels[0].list);
  EXPECT_GT(first, 10);
  for (const draw::Panel& panel : picture.panels) EXPECT_NEAR(edge_px(panel.list) / first, 1, 1e-3);
}

// Each cell alone would have other axes: omega_1 is 0.1 to 0.5 at the start and goes round an axis.
TEST(SweepStage, PlotsHaveTheSameAxes) {
  const std::string plot = "[show]\nviews = false\n[[plot]]\nquantities = [\"omega_1\"]\n";
  const draw::Picture picture = swept(plot, kOne, 5).stage.compose(2, {1600, 400});
  const draw::Color ofAxes = palette(scene::Theme::kLight).quietInk;  // values have omega's colour
  std::map<std::string, int> numbers;
  for (const draw::Text& text : picture.texts)
    if (text.color == ofAxes && text.tex.starts_with("$") &&
        text.tex.find_first_not_of("$-.0123456789") == std::string::npos)
      ++numbers[text.tex];
  EXPECT_GE(numbers.size(), 4u);
  for (const auto& [tex, count] : numbers) EXPECT_EQ(count % 5, 0) << tex << " " << count;
}

// I1 = (2^2 + 1^2)/12 = 5/12 kg·m². Each cell alone would have four digits.
TEST(SweepStage, ReadOutsHaveTheSameDigits) {
  const auto values = [](const std::string& word) {
    std::vector<std::string> all;
    for (const draw::Text& text :
         swept("[[readout]]\nquantity = \"L\"\n", {word}).stage.compose(2, {1600, 400}).texts)
      if (text.tex.starts_with("$") && text.tex.find_first_not_of("$-.0123456789") == std::string::npos)
        all.push_back(text.tex);
    return all;
  };
  EXPECT_THAT(values("motion.omega_body=[0.3|3, 0, 0]"), testing::ElementsAre("$0.125$", "$1.250$"));
  EXPECT_THAT(values("motion.omega_body=[0.01|10, 0, 0]"),
              testing::ElementsAre("$4.167$", "$4.167$"));  // thousandths
}

TEST(SweepStage, GridOfOneRangeHasTheRequestedOrBestColumns) {
  const auto columnsOf = [](const draw::Picture& picture) {
    std::set<int> left;
    for (const draw::Panel& panel : picture.panels) left.insert(panel.origin_px.x);
    return left.size();
  };
  const std::vector<std::string> nine{"motion.omega_body=[0.1..0.9:9, 1, 0]"};
  EXPECT_EQ(columnsOf(swept("", nine).stage.compose(0, {1280, 720})), 3u);
  EXPECT_EQ(columnsOf(swept("", nine, 2).stage.compose(0, {1280, 720})), 2u);
  EXPECT_EQ(columnsOf(swept("", nine, 50).stage.compose(0, {1280, 720})), 9u);
  EXPECT_EQ(columnsOf(swept("", kTwo, 1).stage.compose(0, {1280, 720})), 3u);  // of two ranges it is the first's
}

// A cell is as large as its shorter side: four cells in 1600 x 300 are 300 high in one row, and 150 in two.
TEST(SweepStage, ColumnsFollowTheProportionsOfThePicture) {
  const auto columnsOf = [](int cells, glm::ivec2 size) {
    const draw::Picture picture =
        swept("", {"motion.omega_body=[0.1..0.9:" + std::to_string(cells) + ", 1, 0]"}).stage.compose(0, size);
    std::set<int> left;
    for (const draw::Panel& panel : picture.panels) left.insert(panel.origin_px.x);
    return static_cast<int>(left.size());
  };
  for (const int cells : {4, 5, 6}) EXPECT_EQ(columnsOf(cells, {1600, 300}), cells);
  EXPECT_EQ(columnsOf(5, {1000, 250}), 5);
  EXPECT_EQ(columnsOf(4, {600, 600}), 2);
  EXPECT_EQ(columnsOf(5, {300, 1600}), 1);
}

const char* const kInstants = "time.still=0|0.9|1.8|2.7|3.6";

// Oracle: the picture of the scene alone at each film time.
TEST(SweepStage, CellsOfInstantsShowTheSceneAtTheirOwnFilmTimes) {
  const std::string plot = "[[view]]\n[[plot]]\nquantities = [\"omega_1\"]\n";
  const Made made = swept(plot, {kInstants});
  const draw::Picture picture = made.stage.compose({0, true}, {1600, 500});
  const Stage alone(scene::parseScene(
      "[body]\nshape = 'box'\nsize = [3, 2, 1]\nmass = 1\n[time]\nduration = 10\nspeed = 1\n[motion]\n"
      "omega_body = [1, 0.5, 1.6]\n" +
          plot,
      "sample.toml"));
  ASSERT_EQ(picture.panels.size(), 5u);
  const draw::Picture any = made.stage.compose({7, true}, {1600, 500});
  std::vector<float> cursors;  // x of the dots, from the left end of their cells
  for (const draw::Stroke& stroke : picture.strokes)
    if (stroke.closed)
      cursors.push_back(stroke.points_px.at(0).x -
                        static_cast<float>(picture.panels[static_cast<std::size_t>(stroke.plot - 1)].origin_px.x));
  ASSERT_EQ(cursors.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const double t_s = 0.9 * static_cast<double>(i);
    const draw::Box& box = picture.panels[i].list.boxes.at(0);
    const draw::Picture single = alone.compose({t_s, true}, glm::ivec2(400, 400));
    const glm::mat3 wanted = single.panels.at(0).list.boxes.at(0).halfAxes_V;
    for (int k = 0; k < 3; ++k) EXPECT_LT(glm::length(box.halfAxes_V[k] - wanted[k]), 1e-6f) << i;
    EXPECT_EQ(any.panels[i].list.boxes.at(0).halfAxes_V, box.halfAxes_V);  // the picture's own time has no effect
    EXPECT_EQ(picture.panels[i].list.camera.centre_px, picture.panels[0].list.camera.centre_px);
    EXPECT_EQ(picture.panels[i].list.camera.tanHalfFovY, picture.panels[0].list.camera.tanHalfFovY);
    // Equal steps of time are equal steps on the common time axis.
    EXPECT_NEAR(cursors[i] - cursors[0], static_cast<float>(i) * (cursors[1] - cursors[0]), 0.01f) << i;
  }
  EXPECT_GT(cursors[1] - cursors[0], 1);
}

TEST(SweepStage, NumbersThePlotsOfAllCells) {
  const draw::Picture picture =
      swept("[[plot]]\nquantities = [\"omega_1\"]\n[[plot]]\nquantities = [\"T\"]\n", {kInstants})
          .stage.compose(2, {1600, 500});
  std::set<int> plots;
  for (const draw::Stroke& stroke : picture.strokes) plots.insert(stroke.plot);
  plots.erase(0);
  EXPECT_EQ(plots.size(), 10u);
  EXPECT_EQ(*plots.rbegin(), 10);
}

TEST(SweptName, IsATextbookSymbolOrTheWordsOfTheKey) {
  const scene::Scene aligned = sample();
  const auto name = [&](const std::string& word) { return sweptName(scene::sweepAxis(word).value(), aligned); };
  EXPECT_EQ(name("motion.omega_body=[1,1..2:2,0]"), "$\\omega_2$");
  EXPECT_EQ(name("motion.omega_space=[1,1..2:2,0]"), "$\\omega_y$");
  EXPECT_EQ(name("body.principal_moments=[1,1,1..2:2]"), "$I_3$");
  EXPECT_EQ(name("body.mass=1..2:2"), "$m$");
  EXPECT_EQ(name("camera.azimuth=1..2:2"), "azimuth");
  EXPECT_EQ(name("show.plane.opacity=0.1..0.2:2"), "plane opacity");
  EXPECT_EQ(name("body.size=[1,1..2:2,3]"), "$\\text{size}_2$");
}

TEST(SweepLabels, TypesetNumbersWithUprightUnits) {
  const auto last = [](const std::string& word) {
    const scene::Scene scene = sample();
    const auto labels = sweepLabels({scene::sweepAxis(word).value()}, {}, scene);
    text::setTex(labels[0].whole.back());  // throws if the label cannot be set
    return labels[0].values.back();
  };
  EXPECT_EQ(last("motion.omega_body=[0,1..30 rpm:2,0]"), "$30\\,\\mathrm{rpm}$");
  EXPECT_EQ(last("camera.azimuth=1..30 deg:2"), "$30\\degree$");
  EXPECT_EQ(last("body.principal_moments=[1,2,1..3 kg m^2:2]"), "$3\\,\\mathrm{kg\\,m^2}$");
  EXPECT_EQ(last("body.principal_moments=[1,2,1..3 g·cm²:2]"), "$3\\,\\mathrm{g\\,cm^2}$");
  EXPECT_EQ(last("time.start=1..3 µs:2"), "$3\\,\\mathrm{}\\text{µ}\\mathrm{s}$");
  EXPECT_EQ(last("body.mass=1e-9..3e-9:2:log"), "$3\\times 10^{-9}\\,\\mathrm{kg}$");
  EXPECT_EQ(last("show.plane.opacity=10..30 %:2"), "$30\\,\\mathrm{\\%}$");
  EXPECT_EQ(last("time.speed=1..2.5:2"), "$2.5$");
}

std::vector<std::string> instantLabels(const std::string& range, const std::string& more) {
  const scene::Scene scene = sample("[time]\nduration = 20\n" + more);
  return sweepLabels({scene::sweepAxis("time.still=" + range).value()}, {}, scene)[0].whole;
}

// Motion time = start + speed * film time.
TEST(SweepLabels, WriteInstantsAsTimesOfTheMotion) {
  using testing::ElementsAre;
  EXPECT_THAT(instantLabels("0|0.9|10", "speed = 1\n"),
              ElementsAre("$t = 0.0\\,\\mathrm{s}$", "$t = 0.9\\,\\mathrm{s}$", "$t = 10.0\\,\\mathrm{s}$"));
  EXPECT_THAT(instantLabels("1 s|2 s", "speed = 0.5\nstart = 3\n"),
              ElementsAre("$t = 3.5\\,\\mathrm{s}$", "$t = 4.0\\,\\mathrm{s}$"));
  EXPECT_THAT(instantLabels("500 ms|2000 ms", "speed = 1\n[style]\ndecimal_sign = \"comma\"\n"),
              ElementsAre("$t = 0{,}5\\,\\mathrm{s}$", "$t = 2{,}0\\,\\mathrm{s}$"));
  // The motion is shown a hundred times slower, so that a read-out of t is in milliseconds.
  EXPECT_THAT(instantLabels("0|4", "speed = 0.01\n"),
              ElementsAre("$t = 0\\,\\mathrm{ms}$", "$t = 40\\,\\mathrm{ms}$"));
}

// A hundredth of the step of 0.31415926 s is 0.0031 s; two decimals would be wrong by 0.0042 s.
TEST(SweepLabels, RoundLongTimesWithoutMakingThemEqual) {
  EXPECT_THAT(
      instantLabels("1|2|3", "speed = 0.31415926\n"),
      testing::ElementsAre("$t = 0.314\\,\\mathrm{s}$", "$t = 0.628\\,\\mathrm{s}$", "$t = 0.942\\,\\mathrm{s}$"));
  EXPECT_THAT(instantLabels("1|1.00012345", "speed = 1\n"),
              testing::ElementsAre("$t = 1.000000\\,\\mathrm{s}$", "$t = 1.000123\\,\\mathrm{s}$"));
}

// The timeline halves the speed after 2 s of film; it takes a moment to change.
TEST(SweepLabels, FollowTheSlowMotionOfTheTimeline) {
  const auto labels = instantLabels("2|10|12", "speed = 1\n[[timeline]]\nat = 2\nspeed = 0.5\nover = 1\n");
  EXPECT_EQ(labels[0], "$t = 2.00\\,\\mathrm{s}$");
  // From 2 to 3 s of film, the mean speed is 0.75: t = 2 + 0.75 + 0.5 * 7.
  EXPECT_EQ(labels[1], "$t = 6.25\\,\\mathrm{s}$");
  EXPECT_EQ(labels[2], "$t = 7.25\\,\\mathrm{s}$");
}

}  // namespace
}  // namespace poinsot::stage
