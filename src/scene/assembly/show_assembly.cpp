// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/assembly/shape_reader.h"
#include "scene/assembly/steady_precession.h"

namespace poinsot::scene {
namespace {

struct Thing {
  const char* name;
  bool& visible;
};

std::vector<Thing> construction(Show& show) {
  return {{"ellipsoid", show.ellipsoid.visible},   {"plane", show.plane.visible},
          {"contact", show.contact.visible},       {"polhode", show.polhode.visible},
          {"herpolhode", show.herpolhode.visible}, {"height", show.height.visible}};
}

/// Returns whether L is constant. Dissipation is allowed, because it changes only the energy.
bool momentumIsConstant(const Motion& motion) {
  physics::Forcing others = motion.forcing;
  others.dissipation = 0;
  return others.none() && !motion.rolling;
}

void withoutConstruction(const Motion& motion, const std::string& prefix, Findings& findings, Show& show) {
  const char* const where = motion.rolling ? "for a rolling cone" : "under gravity, torque or drag";
  for (const Thing& thing : construction(show)) {
    const std::string path = fmt::format("{}show.{}.visible", prefix, thing.name);
    if (findings.has(path) && thing.visible)
      findings.refuse(
          path,
          fmt::format("{} L is not constant, so Poinsot's construction does not exist; leave it out", where));
    thing.visible = false;
  }
}

/// Returns the visible things that do not exist for a body at rest, as a list such as "show.L, show.omega".
std::string needingRotation(const std::string& prefix, Show& show) {
  std::vector<Thing> things = {{"L", show.L.visible}, {"omega", show.omega.visible}};
  for (const Thing& thing : construction(show)) things.push_back(thing);
  std::string names;
  for (const Thing& thing : things)
    if (thing.visible) names += fmt::format("{}{}show.{}", names.empty() ? "" : ", ", prefix, thing.name);
  return names;
}

/// Returns the solid for a drawn shape without a size. Uses the extents of the body if the shape accepts them, and
/// the default proportions of the shape otherwise.
physics::Solid proportions(const Draft& draft) {
  const NamedShape& kind = namedShapes()[static_cast<std::size_t>(*draft.drawn.word)];
  const ShapeDraft& whole = draft.body.whole.shape;
  const bool takesSize = std::find(kind.ways.begin(), kind.ways.end(), KeyNames{"size"}) != kind.ways.end();
  if (!takesSize || !whole.size || !extentsSuit(kind, *whole.size)) return kind.usual;
  ShapeDraft drawn;
  drawn.size = whole.size;
  return kind.make(drawn);
}

constexpr const char* kNothingIsThrown = "nothing is thrown: give [motion.flight], or leave it out";
constexpr const char* kTopIsNotThrown =
    "nothing is thrown: give [motion.flight], or leave it out; to draw the weight of a top, add the table "
    "[[vector]] "
    "with components = [0, 0, -1] and name = '$M\\mathbf{g}$'";

void checkThrown(const Scene& scene, const std::string& prefix, Findings& findings, const Show& show) {
  const std::string flight = prefix + "show.flight", total = prefix + "show.total_L";
  if (!scene.motion.flight && findings.hasBelow(flight) && show.figures.flight.visible)
    findings.refuse(flight, findings.hasTable("motion.gravity") ? kTopIsNotThrown : kNothingIsThrown);
  const bool asked = show.figures.totalL.visible && (prefix.empty() || findings.hasBelow(total));
  if (asked && !scene.motion.flight)
    findings.refuse(total, "exists only for a thrown body: give [motion.flight], or leave it out");
  else if (asked && massIsUnknown(findings))
    findings.refuse(total, kNeedsMass);
}

void checkForces(const std::string& prefix, Findings& findings, const Show& show) {
  const std::string path = prefix + "show.forces";
  if (findings.count("motion.force") == 0 && findings.hasBelow(path) && show.figures.forces.visible)
    findings.refuse(path, "no force acts at a point of the body: give [[motion.force]], or leave it out");
}

/// Rejects visible cones, and what belongs to a steady precession, if the motion does not have them.
void checkPrecession(const Scene& scene, const std::optional<Rest>& rest, const std::string& prefix,
                     Findings& findings, const Show& show) {
  const bool startKnown = rest || !scene.motion.omega_B.isZero(0);
  if (!startKnown) return;
  using Why = std::string (*)(const Scene&, const std::optional<Rest>&);
  const auto check = [&](const char* thing, bool visible, Why without) {
    const std::string path = prefix + thing;
    if (!visible || !(prefix.empty() || findings.hasBelow(path))) return;
    if (const std::string why = without(scene, rest); !why.empty()) findings.refuse(path, why + "; leave it out");
  };
  check("show.cones", show.figures.cones.visible, withoutCones);
  if (!scene.motion.rolling) check("show.decomposition", show.figures.decomposition.visible, withoutPrecession);
  check("show.L_parts", show.figures.LParts.visible, withoutPrecession);
  check("show.triad", show.figures.triad.visible, withoutTriad);
}

void checkTable(const Scene& scene, const std::string& prefix, Findings& findings, const Show& show) {
  const std::string table = prefix + "show.table";
  if (!scene.motion.rolling && findings.hasBelow(table) && show.figures.table.visible &&
      !findings.hasTable("motion.rolling"))
    findings.refuse(table, "nothing rolls on a table: give [motion.rolling], or leave it out");
}

}  // namespace

void leaveOutOfFlight(const Findings& findings, Show& show) {
  if (!findings.hasTable("motion.flight") || !show.figures.flight.visible) return;
  for (const Thing& thing : construction(show))
    if (!findings.hasBelow(fmt::format("show.{}", thing.name))) thing.visible = false;
}

void assembleDrawnShape(const Draft& draft, Findings& findings, const SceneFolder& folder, Show& show) {
  ShapeReader reader(draft.drawn, "show.body", findings, folder);
  if (!reader.given() || findings.failed("show.body.shape")) return;
  if (!reader.sized() && namedShapes()[static_cast<std::size_t>(*draft.drawn.word)].make)
    show.body.parts = {asPart(proportions(draft))};
  else if (const auto figure = reader.figure())
    show.body.parts = {asPart(*figure)};
}

void assembleVisible(const Scene& scene, const std::optional<Rest>& rest, const std::string& prefix,
                     Findings& findings, Show& show) {
  const Motion& motion = scene.motion;
  checkThrown(scene, prefix, findings, show);
  checkForces(prefix, findings, show);
  checkPrecession(scene, rest, prefix, findings, show);
  checkTable(scene, prefix, findings, show);
  if (!momentumIsConstant(motion)) withoutConstruction(motion, prefix, findings, show);
  const std::string shown = rest ? needingRotation(prefix, show) : "";
  if (!shown.empty())
    findings.refuse(rest->path,
                    fmt::format("must not be zero, got {}: without rotation there is nothing to draw for "
                                "{}; give a rotation, or set these to false",
                                rest->value, shown));
  if (prefix.empty() && !motion.isFree() && show.exaggerateAngles != 1)
    findings.refuse("show.exaggerate_angles",
                    "exaggerated angles belong to another motion, which is exact only if nothing acts on the "
                    "body; leave it out");
}

}  // namespace poinsot::scene
