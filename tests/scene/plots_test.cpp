// SPDX-License-Identifier: Apache-2.0
// Plots, read-outs and notes: their keys, their places in the picture, and errors with their places.
#include <gmock/gmock.h>

#include <array>

#include "scene/state_quantity.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kTop = "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.5, 0, 1]\n";

Scene sceneWith(const std::string& extra, const std::vector<std::string>& overrides = {}) {
  return parseScene(kTop + extra, "test.toml", overrides);
}

std::string messagesWith(const std::string& extra) { return messagesOf(kTop + extra, {}); }

std::vector<std::string> namesOf(const std::vector<int>& quantities) {
  std::vector<std::string> names;
  for (const int q : quantities) names.emplace_back(stateQuantity(q).name);
  return names;
}

std::array<int, 4> cells(const GridPlace& p) { return {p.column, p.row, p.columns, p.rows}; }

TEST(Plots, AreAbsentByDefault) {
  const Scene scene = sceneWith("");
  EXPECT_TRUE(scene.plots.empty() && scene.readouts.empty() && scene.notes.empty());
  EXPECT_EQ(scene.style.decimalSign, DecimalSign::kPoint);
}

TEST(Plots, ReadTheirKeysAndDefaults) {
  const Scene scene = sceneWith(
      "[[plot]]\nquantities = [\"omega_3\", \"omega_1\"]\n[[plot]]\nquantities = [\"theta\"]\nx = \"omega\"\n"
      "title = \"A\"\nrange = [-5, 30.5]\nfuture = false\ncursor = false\n[[plot]]\nquantities = [\"T\"]\ntime = "
      "\"film\"\n");
  ASSERT_EQ(scene.plots.size(), 3u);
  const Plot &first = scene.plots[0], &second = scene.plots[1];
  EXPECT_THAT(namesOf(first.quantities), ElementsAre("omega_3", "omega_1"));
  EXPECT_FALSE(first.x || first.range);
  EXPECT_TRUE(first.future && first.cursor && first.title.empty());
  EXPECT_EQ(first.time, PlotTime::kMotion);
  EXPECT_EQ(stateQuantity(second.x.value()).name, "omega");
  EXPECT_EQ(second.title, "A");
  EXPECT_EQ(second.range->low, -5);
  EXPECT_EQ(second.range->high, 30.5);
  EXPECT_FALSE(second.future || second.cursor);
  EXPECT_EQ(scene.plots[2].time, PlotTime::kFilm);
}

TEST(Plots, AcceptAUnitAsReadoutsDo) {
  const Scene scene = sceneWith(
      "[[plot]]\nquantities = [\"omega_3\"]\nunit = \"rpm\"\n[[readout]]\nquantity = "
      "\"theta\"\nunit = \"rad\"\n");
  EXPECT_EQ(scene.plots.at(0).unit, "rpm");
  EXPECT_EQ(scene.readouts.at(0).unit, "rad");
  EXPECT_THAT(messagesWith("[[plot]]\nquantities = [\"omega_3\"]\nunit = \"deg\"\n"),
              HasSubstr("plot[0].unit: expected a unit of an angular velocity, such as rad/s, deg/s, deg/h, rpm, "
                        "rev/s, rev/d, Hz, kHz (poinsot explain units lists all), got \"deg\"\n"));
  EXPECT_THAT(messagesWith("[[readout]]\nquantity = \"T\"\nunit = \"\"\n"), HasSubstr("readout[0].unit: "));
  EXPECT_THAT(messagesWith("[[readout]]\nquantity = \"q_w\"\nunit = \"m\"\n"),
              HasSubstr("readout[0].unit: \"q_w\" is a bare number and has no unit; leave it out"));
}

TEST(Readouts, SuggestTheNearestQuantity) {
  EXPECT_EQ(messagesWith("[[readout]]\nquantity = \"omega_mag\"\nunit = \"rpm\"\n"),
            "readout[0].quantity: expected one of the quantities, got \"omega_mag\"; did you mean \"omega\"?\n");
  EXPECT_THAT(messagesWith("[[readout]]\nquantity = \"omega1\"\n"), HasSubstr("did you mean \"omega_1\"?"));
  EXPECT_THAT(messagesWith("[[readout]]\nquantity = \"zzzzzzzz\"\n"),
              HasSubstr("expected one of \"t\", \"omega_1\","));
}

TEST(Plots, ArePlacedInTheGridOfTheViews) {
  const auto places = [](const std::string& extra) {
    const Scene scene = sceneWith(extra);
    std::vector<std::array<int, 4>> all;
    for (const View& view : scene.views) all.push_back(cells(view.place));
    for (const Plot& plot : scene.plots) all.push_back(cells(plot.place));
    return all;
  };
  using Places = std::vector<std::array<int, 4>>;
  const std::string plot = "[[plot]]\nquantities = [\"T\"]\n";
  EXPECT_EQ(places(plot + plot), (Places{{0, 0, 1, 1}, {1, 0, 1, 1}, {2, 0, 1, 1}}));
  // Views come first, for any order of the tables in the file.
  EXPECT_EQ(places(plot + "[[view]]\nspan = [1, 2]\n" + plot + "at = [1, 1]\n"),
            (Places{{0, 0, 1, 2}, {1, 0, 1, 1}, {1, 1, 1, 1}}));
  EXPECT_EQ(places("[camera]\nframes = [\"space\", \"body\"]\n" + plot + "span = [2, 3]\n"),
            (Places{{0, 0, 1, 1}, {1, 0, 1, 1}, {2, 0, 2, 3}}));
}

TEST(Plots, MustNotOverlapPanelsOrLeaveTheGrid) {
  const std::string plot = "[[plot]]\nquantities = [\"T\"]\n";
  EXPECT_EQ(messagesWith(plot + "at = [0, 0]\n"),
            "plot[0].at: the panel at [0, 0] would overlap the view; give another at\n");
  EXPECT_EQ(messagesWith("[[view]]\n" + plot + "at = [0, 0]\n"),
            "plot[0].at: the panel at [0, 0] would overlap view[0]; give another at\n");
  EXPECT_EQ(messagesWith(plot + plot + "at = [1, 0]\n"),
            "plot[1].at: the panel at [1, 0] would overlap plot[0]; give another at\n");
  EXPECT_THAT(messagesWith(plot + "span = [8, 1]\n"),
              HasSubstr("plot[0].at: the panel at [1, 0] would extend beyond"));
}

TEST(Plots, NeedQuantitiesOfOneUnit) {
  EXPECT_THAT(messagesWith("[[plot]]\n"), HasSubstr("plot[0].quantities: is required, such as [\"omega_1\""));
  EXPECT_THAT(messagesWith("[[plot]]\nquantities = [\"omega_4\"]\n"), HasSubstr("got \"omega_4\"; did you mean"));
  const auto problems = problemsOf(kTop + "[[plot]]\nquantities = [\"omega_1\", \"theta\"]\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(
      problems[0].message,
      "plot[0].quantities: a plot has one unit, but \"omega_1\" is in rad/s and \"theta\" an angle; give each "
      "unit a [[plot]] of its own");
  EXPECT_EQ(problems[0].where.line, 6);
  EXPECT_EQ(problems[0].where.column, 14);
}

TEST(Plots, PhasePortraitTakesOneQuantityAndNoTime) {
  EXPECT_THAT(messagesWith("[[plot]]\nquantities = [\"omega_1\", \"omega_2\"]\nx = \"theta\"\n"),
              HasSubstr("plot[0].quantities: a phase portrait shows one quantity against x, got 2"));
  EXPECT_THAT(messagesWith("[[plot]]\nquantities = [\"omega_1\"]\nx = \"theta\"\ntime = \"film\"\n"),
              HasSubstr("plot[0].time: a phase portrait has no time axis"));
}

TEST(Plots, RejectRangesThatDoNotAscend) {
  for (const char* range : {"[1, 1]", "[2, 1]"}) {
    const auto problems = problemsOf(kTop + "[[plot]]\nquantities = [\"T\"]\nrange = " + range + "\n");
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_THAT(
        problems[0].message,
        HasSubstr("plot[0].range: must run from a lower number to a higher one, got [" + std::string(range + 1)));
    EXPECT_EQ(problems[0].where.line, 7);
  }
}

TEST(Plots, MayReplaceTheViews) {
  const Scene scene = sceneWith("[show]\nviews = false\n[[plot]]\nquantities = [\"T\"]\n");
  EXPECT_TRUE(scene.views.empty());
  EXPECT_EQ(cells(scene.plots.at(0).place), (std::array<int, 4>{0, 0, 1, 1}));
  EXPECT_EQ(messagesWith("[show]\nviews = false\n"),
            "show.views: without views and without a [[plot]] nothing is left to draw\n");
  EXPECT_THAT(messagesWith("[show]\nviews = false\n[[view]]\n[[plot]]\nquantities = [\"T\"]\n"),
              HasSubstr("show.views: is false, but the scene has a [[view]]"));
}

TEST(Plots, MayBeOverridden) {
  const Scene scene = sceneWith("[[plot]]\nquantities = [\"T\"]\n", {"plot[0].quantities=[\"E\", \"V\"]"});
  EXPECT_THAT(namesOf(scene.plots.at(0).quantities), ElementsAre("E", "V"));
}

TEST(Readouts, ReadTheirKeysAndDefaults) {
  const Scene scene = sceneWith(
      "[[readout]]\nquantity = \"t\"\n[[readout]]\nquantity = \"L\"\nat = \"bottom\"\nlabel = \"spin\"\n");
  ASSERT_EQ(scene.readouts.size(), 2u);
  EXPECT_EQ(stateQuantity(scene.readouts[0].quantity).name, "t");
  EXPECT_EQ(scene.readouts[0].at, Spot::kTopRight);
  EXPECT_EQ(scene.readouts[0].label, "");
  EXPECT_EQ(scene.readouts[1].at, Spot::kBottom);
  EXPECT_EQ(scene.readouts[1].label, "spin");
  EXPECT_THAT(messagesWith("[[readout]]\nat = \"left\"\n"), HasSubstr("readout[0].quantity: is required"));
  EXPECT_THAT(messagesWith("[[readout]]\nquantity = \"t\"\nat = \"top_left\"\n"),
              HasSubstr("got \"top_left\"; did you mean \"top left\"?"));
}

TEST(Notes, TakeTheirLinesFromTextOrAnArray) {
  const auto linesOf = [](const std::string& text) {
    return sceneWith("[[note]]\ntext = " + text + "\n").notes.at(0).lines;
  };
  EXPECT_THAT(linesOf("\"one\""), ElementsAre("one"));
  EXPECT_THAT(linesOf("\"one\\ntwo\""), ElementsAre("one", "two"));
  EXPECT_THAT(linesOf("\"\"\"\none\n\nthree\n\"\"\""), ElementsAre("one", "", "three"));
  EXPECT_THAT(linesOf("['one', 'two']"), ElementsAre("one", "two"));
}

TEST(Notes, ReadTheirKeysAndDefaults) {
  const Scene scene =
      sceneWith("[[note]]\ntext = \"a\"\n[[note]]\ntext = \"b\"\nat = \"centre\"\nsize = \"150 %\"\n");
  EXPECT_EQ(scene.notes.at(0).at, Spot::kBottom);
  EXPECT_EQ(scene.notes[0].size, 1);
  EXPECT_EQ(scene.notes.at(1).at, Spot::kCentre);
  EXPECT_EQ(scene.notes[1].size, 1.5);
  EXPECT_THAT(messagesWith("[[note]]\nat = \"left\"\n"), HasSubstr("note[0].text: is required"));
}

TEST(Notes, RejectControlCharactersAndTooMuchText) {
  EXPECT_THAT(messagesWith("[[note]]\ntext = [\"a\", \"b\\tc\"]\n"),
              HasSubstr("note[0].text: must not contain line ends"));
  EXPECT_THAT(messagesWith("[[note]]\ntext = [\"a\\nb\"]\n"),
              HasSubstr("note[0].text: must not contain line ends"));
  EXPECT_THAT(messagesWith("[[note]]\ntext = \"" + std::string(201, 'a') + "\"\n"),
              HasSubstr("may have at most 200 characters, got 201"));
  std::string many;
  for (int i = 0; i < 41; ++i) many += "a\\n";
  EXPECT_THAT(messagesWith("[[note]]\ntext = \"" + many + "\"\n"), HasSubstr("may have at most 40 lines, got 41"));
}

// Each line is checked separately, and an error points at the element of an array.
TEST(TextCheck, CoversPlotsReadoutsAndNotes) {
  const TextCheck check = [](std::string_view text) { return std::string(text == "bad" ? "no TeX" : ""); };
  const auto placeOf = [&](const std::string& extra) {
    try {
      parseScene(kTop + extra, "test.toml", {}, check);
    } catch (const SceneErrors& errors) {
      return std::pair(errors.problems().at(0).where.line, errors.problems().at(0).where.column);
    }
    return std::pair(0, 0);
  };
  EXPECT_EQ(placeOf("[[plot]]\nquantities = [\"T\"]\ntitle = \"bad\"\n"), std::pair(7, 9));
  EXPECT_EQ(placeOf("[[readout]]\nquantity = \"T\"\nlabel = \"bad\"\n"), std::pair(7, 9));
  EXPECT_EQ(placeOf("[[note]]\ntext = [\"good\", \"bad\"]\n"), std::pair(6, 17));
  EXPECT_EQ(placeOf("[[note]]\ntext = \"good\\nbad\"\n"), std::pair(6, 8));
  EXPECT_EQ(placeOf("[[note]]\ntext = \"good\"\n"), std::pair(0, 0));
}

TEST(Style, ReadsTheDecimalSign) {
  EXPECT_EQ(sceneWith("[style]\ndecimal_sign = \"comma\"\n").style.decimalSign, DecimalSign::kComma);
}

}  // namespace
}  // namespace poinsot::scene
