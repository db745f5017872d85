// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"
#include "scene/state_quantity.h"

namespace poinsot::scene {
namespace {

using enum ValueType;

// Range for the ends of an axis, in the unit of the axis. Far beyond any value in a plot.
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
       .help = "Quantities that the plot shows as curves. All must have the same unit. Curves of related "
               "quantities, such as the components of omega, are tones of one colour.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.quantities; })},
      {.path = "plot[].x",
       .type = kWord,
       .words = quantityWords(),
       .wordList = "quantities",
       .example = "\"theta\"",
       .help = "Quantity on the horizontal axis of the plot instead of time. A plot with this key is a phase "
               "portrait and has one curve.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.x; })},
      {.path = "plot[].title",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "'Components of $\\boldsymbol{\\omega}$'",
       .help = "Title over the curves, written like show.title.",
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
       .help = "Unit of the values in the plot. By default, poinsot chooses a unit that suits the numbers.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.unit; })},
      {.path = "plot[].range",
       .type = kPair,
       .range = kAxisEnds,
       .example = "[-2, 2]",
       .help = "Ends of the plot's vertical axis, in the unit that is written at the axis. By default, the axis "
               "covers all values of the film.",
       .put = intoPlot([](PlotDraft& p) { return &p.range; })},
      {.path = "plot[].time",
       .type = kWord,
       .words = {"motion", "film"},
       .example = "\"film\"",
       .help = "Time on the horizontal axis of the plot. It is the time of the motion (the default) or the time "
               "of the film.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.time; })},
      {.path = "plot[].future",
       .type = kBool,
       .example = "false",
       .help = "Whether the part of the curve that is still to come is also drawn, as a faint line. The default "
               "is true.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.future; })},
      {.path = "plot[].cursor",
       .type = kBool,
       .example = "false",
       .help = "Whether the plot marks the instant of the picture, with a line, a dot and the value beside the "
               "curve. If false, the whole curve is drawn in its full colour, as in a printed figure. The default "
               "is true.",
       .put = intoPlot([](PlotDraft& p) { return &p.plot.cursor; })},
      cellKey("plot[].at", kCellNumber, "[1, 1]",
              "Column and row of the plot's top left cell, counted in the same grid as the panels. By default, "
              "the plot is to the right of the panel before.",
              intoPlot([](PlotDraft& p) { return &p.at; })),
      cellKey("plot[].span", kCellCount, "[2, 1]",
              "Number of columns and rows that the plot takes. The default is one column and one row.",
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
