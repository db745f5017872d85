// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"
#include "scene/state_quantity.h"

namespace poinsot::scene {
namespace {

using enum ValueType;

// In the unit of the axis, which keeps numbers short: far beyond any number read off a plot.
constexpr Range kAxisEnds{.least = -1e12, .most = 1e12};

template <class F>
Put intoPlot(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.plots, i)); });
}

std::vector<Key> curveKeys() {
  return {
      {.path = "plot[].quantities",
       .type = kWords,
       .words = quantityWords(),
       .wordList = "quantities",
       .example = "[\"omega_1\", \"omega_2\"]",
       .help = "What the curves show, all of one unit; each is drawn in the colour of its family.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.quantities; })},
      {.path = "plot[].x",
       .type = kWord,
       .words = quantityWords(),
       .wordList = "quantities",
       .example = "\"theta\"",
       .help = "Makes a phase portrait: the one quantity against this one instead of time.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.x; })},
      {.path = "plot[].title",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "'Components of $\\boldsymbol{\\omega}$'",
       .help = "A few words over the curves, as show.title is over the picture.",
       .isTex = true,
       .put = intoPlot([](PlotDraft& p) { return &p.plot.title; })},
  };
}

std::vector<Key> axisKeys() {
  return {
      {.path = "plot[].unit",
       .type = kText,
       .range = {.least = 0, .most = kLongestUnit},
       .example = "\"rpm\"",
       .help = "In which the values are written; without it, in one that suits the numbers.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.unit; })},
      {.path = "plot[].range",
       .type = kPair,
       .range = kAxisEnds,
       .example = "[-2, 2]",
       .help = "Ends of the vertical axis, in the unit written at it; without it, all that the film needs.",
       .put = intoPlot([](PlotDraft& p) { return &p.range; })},
      {.path = "plot[].time",
       .type = kWord,
       .words = {"motion", "film"},
       .example = "\"film\"",
       .help = "Which time runs along the axis: that of the motion, as without it, or that of the film.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.time; })},
      {.path = "plot[].future",
       .type = kBool,
       .example = "false",
       .help = "Whether the part that is still to come is drawn too, faintly; without it, it is.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.future; })},
      cellKey(
          "plot[].at", kCellNumber, "[1, 1]",
          "Column and row of the plot's top left cell in the grid of the views; without it, to the right of the "
          "panel before.",
          intoPlot([](PlotDraft& p) { return &p.at; })),
      cellKey("plot[].span", kCellCount, "[2, 1]", "Columns and rows that the plot takes; without it, one cell.",
              intoPlot([](PlotDraft& p) { return &p.span; })),
  };
}

}  // namespace

std::vector<std::string_view> quantityWords() {
  std::vector<std::string_view> words;
  for (const StateQuantity& quantity : stateQuantities()) words.push_back(quantity.name);
  return words;
}

std::vector<Key> plotKeys() { return joined({curveKeys(), axisKeys()}); }

}  // namespace poinsot::scene
