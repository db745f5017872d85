// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/actors.h"

#include <map>
#include <set>
#include <tuple>
#include <type_traits>

#include "stage/figures/axes_figure.h"
#include "stage/figures/body_actor.h"
#include "stage/figures/cones_figure.h"
#include "stage/figures/construction_figures.h"
#include "stage/figures/decomposition_figure.h"
#include "stage/figures/flight_figures.h"
#include "stage/figures/forces_figure.h"
#include "stage/figures/ghosts_figure.h"
#include "stage/figures/main_axis_figure.h"
#include "stage/figures/momentum_parts_figure.h"
#include "stage/figures/named_figures.h"
#include "stage/figures/omega_paths_figure.h"
#include "stage/figures/plane_of_L_figure.h"
#include "stage/figures/polhode_cones_figure.h"
#include "stage/figures/polhodes_figure.h"
#include "stage/figures/principal_axes_figure.h"
#include "stage/figures/symmetric_top.h"
#include "stage/figures/table_figure.h"
#include "stage/figures/trace_figure.h"
#include "stage/figures/triad_figure.h"
#include "stage/figures/vector_figures.h"

namespace poinsot::stage {
namespace {

template <class A>
constexpr std::type_identity<A> kA{};

/// Returns the angles whose arcs must be inside the picture. Of several angles between the same two directions,
/// only the arc with the largest radius counts: if it and the centre are inside the picture, the smaller arcs are
/// inside too. In a flight, the centre may be outside the picture, so all radii count.
std::set<const scene::NamedAngle*> outermost(const std::vector<scene::NamedAngle>& angles, bool flight) {
  std::map<std::tuple<scene::Direction, scene::Direction, double>, const scene::NamedAngle*> widest;
  for (const scene::NamedAngle& angle : angles) {
    const scene::NamedAngle*& known = widest[{angle.from, angle.to, flight ? angle.scale : 0}];
    if (known == nullptr || angle.scale > known->scale) known = &angle;
  }
  std::set<const scene::NamedAngle*> all;
  for (const auto& [directions, angle] : widest) all.insert(angle);
  return all;
}

}  // namespace

bool showsConstruction(const scene::Show& show, const PictureMotion& motion) {
  return !motion.liveliest().omega_P.isZero(0) &&
         (show.ellipsoid.visible || show.plane.visible || show.polhode.visible || show.herpolhode.visible ||
          show.contact.visible);
}

std::vector<ShownActor> makeActors(const Setting& setting) {
  const scene::Show& show = setting.scene.show;
  std::vector<ShownActor> actors;
  const auto addIf = [&]<class A>(bool shown, std::string_view name, std::type_identity<A>) {
    if (shown) actors.push_back({name, std::make_unique<A>(setting)});
  };
  addIf(show.body.visible, "body", kA<BodyActor>);
  addIf(show.principalAxes.visible, "principal_axes", kA<PrincipalAxesFigure>);
  addIf(show.L.visible, "L", kA<AngularMomentumFigure>);
  addIf(show.omega.visible, "omega", kA<AngularVelocityFigure>);
  if (setting.construction) {
    const bool surface = show.plane.visible || show.ellipsoid.visible;
    addIf(show.plane.visible && show.height.visible, "height", kA<HeightFigure>);
    addIf(show.herpolhode.visible, "herpolhode", kA<HerpolhodeFigure>);
    addIf(show.ellipsoid.visible, "ellipsoid", kA<EllipsoidFigure>);
    addIf(show.plane.visible, "plane", kA<PlaneFigure>);
    addIf(show.polhode.visible, "polhode", kA<PolhodeFigure>);
    addIf(surface && show.contact.visible, "contact", kA<ContactFigure>);
  }
  const scene::ShownFigures& figures = show.figures;
  addIf(figures.trace.visible, "trace", kA<TraceFigure>);
  const bool circular = isSymmetric(setting.motion);
  addIf(figures.cones.visible && circular, "cones", kA<ConesFigure>);
  addIf(figures.cones.visible && !circular, "cones", kA<PolhodeConesFigure>);
  addIf(figures.mainAxis.visible, "main_axis", kA<MainAxisFigure>);
  addIf(figures.theta.visible, "theta", kA<ThetaFigure>);
  addIf(figures.decomposition.visible, "decomposition", kA<DecompositionFigure>);
  addIf(figures.LParts.visible, "L_parts", kA<MomentumPartsFigure>);
  addIf(figures.triad.visible, "triad", kA<TriadFigure>);
  addIf(figures.components.visible, "components", kA<ComponentsFigure>);
  addIf(figures.spaceAxes.visible, "space_axes", kA<SpaceAxesFigure>);
  addIf(figures.polhodes.visible, "polhodes", kA<PolhodesFigure>);
  addIf(figures.binet.visible, "binet", kA<BinetFigure>);
  addIf(figures.torque.visible, "torque", kA<TorqueFigure>);
  addIf(figures.forces.visible && !setting.scene.motion.forcing.forces.empty(), "forces", kA<ForcesFigure>);
  addIf(figures.planeOfL.visible, "plane_of_L", kA<PlaneOfLFigure>);
  if (setting.motion.rolling()) addIf(figures.table.visible, "table", kA<TableFigure>);
  if (setting.motion.flight()) {
    addIf(true, "flight", kA<FlightFigure>);
    addIf(figures.totalL.visible, "total_L", kA<TotalAngularMomentumFigure>);
  }
  addIf(figures.ghosts.visible, "ghosts", kA<GhostsFigure>);
  for (const scene::NamedVector& vector : setting.scene.vectors)
    actors.push_back({"vectors", std::make_unique<NamedVectorFigure>(setting, vector)});
  const auto framed = outermost(setting.scene.angles, setting.motion.flight().has_value());
  for (const scene::NamedAngle& angle : setting.scene.angles)
    actors.push_back({"angles", std::make_unique<AngleFigure>(setting, angle, framed.contains(&angle))});
  return actors;
}

}  // namespace poinsot::stage
