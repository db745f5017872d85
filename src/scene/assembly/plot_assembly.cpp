// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"
#include "scene/body_matrix.h"
#include "scene/motion/quantity_basis.h"
#include "scene/state_quantity.h"

namespace poinsot::scene {
namespace {

/// Returns element i, or a default element if i is beyond the end. The vector ends at the last table with a valid
/// key, so it may be shorter than the array of tables in the file.
template <class T>
T elementOrNone(const std::vector<T>& elements, std::size_t i) {
  return i < elements.size() ? elements[i] : T();
}

void require(const std::string& path, const char* example, Findings& findings) {
  if (!findings.has(path)) findings.refuseMissing(path, path, fmt::format("is required, such as {}", example));
}

/// Reports a problem if the scene lacks what the quantity needs.
void checkExists(int quantity, const std::string& path, const Scene& scene, Findings& findings) {
  const StateQuantity& q = stateQuantity(quantity);
  const std::string lack = lackFor(q, scene);
  // If the body or the point by which it is thrown failed, its problem is already reported.
  const bool bodyFailed = !scene.body.mass && !massIsUnknown(findings);
  const bool pointFailed = q.needs == QuantityNeeds::kFlightByPoint && findings.has("motion.flight.point");
  if (lack.empty() || (scene.motion.flight && (bodyFailed || pointFailed))) return;
  findings.refuse(path, fmt::format("\"{}\" {}", q.name, lack));
}

void checkUnits(const Plot& plot, const std::string& path, Findings& findings) {
  const auto unit = [](int q) { return stateQuantity(q).unit; };
  const auto other =
      std::ranges::find_if(plot.quantities, [&](int q) { return unit(q) != unit(plot.quantities.front()); });
  if (other == plot.quantities.end()) return;
  const StateQuantity &a = stateQuantity(plot.quantities.front()), &b = stateQuantity(*other);
  findings.refuse(path + ".quantities",
                  fmt::format("a plot has one unit, but \"{}\" is {} and \"{}\" {}; give each unit a [[plot]] of "
                              "its own",
                              a.name, unitText(a.unit), b.name, unitText(b.unit)));
}

void checkUnit(const std::string& unit, int quantity, const std::string& path, Findings& findings) {
  if (!findings.has(path) || findings.failed(path)) return;
  const StateQuantity& q = stateQuantity(quantity);
  const Dimension dimension = dimensionOf(q.unit);
  if (dimension == Dimension::kNone)
    return findings.refuse(path, fmt::format("\"{}\" is a bare number and has no unit; leave it out", q.name));
  if (!parseQuantity("1 " + unit, dimension).ok())
    findings.refuse(path, fmt::format("expected a unit of {}, such as {}, got \"{}\"", quantityName(dimension),
                                      someUnits(dimension), core::printable(unit)));
}

void checkPortrait(const Plot& plot, const std::string& path, Findings& findings) {
  if (!plot.x) return;
  if (plot.quantities.size() > 1)
    findings.refuse(path + ".quantities",
                    fmt::format("a phase portrait shows one quantity against x, got {}; give each a [[plot]] of "
                                "its own, or leave x out to draw them over time",
                                plot.quantities.size()));
  if (findings.has(path + ".time"))
    findings.refuse(path + ".time", "a phase portrait has no time axis; leave out time or x");
}

void checkRange(const Plot& plot, const std::string& path, Findings& findings) {
  if (plot.range && !(plot.range->low < plot.range->high))
    findings.refuse(path + ".range", fmt::format("must run from a lower number to a higher one, got [{}, {}]",
                                                 plot.range->low, plot.range->high));
}

void checkMatrix(const Note& note, const std::string& path, const Body& body, Findings& findings) {
  if (!note.matrix) return;
  const std::string_view word = bodyMatrixWords()[static_cast<std::size_t>(*note.matrix)];
  const std::string lack = lackFor(body, *note.matrix);
  if (!lack.empty() && findings.none()) findings.refuse(path + ".matrix", fmt::format("\"{}\" {}", word, lack));
  if (note.lines.size() > 1)
    findings.refuse(path + ".text", fmt::format("the name of a matrix is one line, got {}", note.lines.size()));
}

}  // namespace

void assemblePlots(const Draft& draft, Findings& findings, PanelGrid& grid, Scene& scene) {
  for (std::size_t i = 0; i < findings.count("plot"); ++i) {
    const std::string path = fmt::format("plot[{}]", i);
    const PlotDraft given = elementOrNone(draft.plots, i);
    Plot plot = given.plot;
    require(path + ".quantities", "[\"omega_1\", \"omega_2\"]", findings);
    for (const int quantity : plot.quantities) checkExists(quantity, path + ".quantities", scene, findings);
    if (plot.x) checkExists(*plot.x, path + ".x", scene, findings);
    checkUnits(plot, path, findings);
    if (!plot.quantities.empty()) checkUnit(plot.unit, plot.quantities.front(), path + ".unit", findings);
    checkPortrait(plot, path, findings);
    if (given.range) plot.range = PlotRange{(*given.range)[0], (*given.range)[1]};
    checkRange(plot, path, findings);
    plot.place = grid.take(path, given.at, given.span);
    scene.plots.push_back(std::move(plot));
  }
}

void assembleNotes(const Draft& draft, Findings& findings, Scene& scene) {
  for (std::size_t i = 0; i < findings.count("readout"); ++i) {
    const std::string path = fmt::format("readout[{}]", i), quantity = path + ".quantity";
    require(quantity, "\"t\"", findings);
    const Readout& readout = scene.readouts.emplace_back(elementOrNone(draft.readouts, i));
    checkExists(readout.quantity, quantity, scene, findings);
    if (findings.has(quantity) && !findings.failed(quantity))
      checkUnit(readout.unit, readout.quantity, path + ".unit", findings);
  }
  for (std::size_t i = 0; i < findings.count("note"); ++i) {
    const std::string path = fmt::format("note[{}]", i);
    if (!findings.has(path + ".matrix"))
      require(path + ".text", "'$T = \\frac{1}{2}\\,\\boldsymbol{\\omega}\\cdot\\mathbf{L}$'", findings);
    scene.notes.push_back(elementOrNone(draft.notes, i));
    checkMatrix(scene.notes.back(), path, scene.body, findings);
  }
}

}  // namespace poinsot::scene
