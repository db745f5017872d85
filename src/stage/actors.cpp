// SPDX-License-Identifier: Apache-2.0
#include "stage/actors.h"

#include <type_traits>

#include "stage/axes_figure.h"
#include "stage/cones_figure.h"
#include "stage/decomposition_figure.h"
#include "stage/polhodes_figure.h"
#include "stage/theta_figure.h"
#include "stage/trace_figure.h"

namespace poinsot::stage {

std::vector<std::unique_ptr<const Actor>> makeActors(const Setting& setting) {
  const scene::ShownFigures& show = setting.scene.show.figures;
  std::vector<std::unique_ptr<const Actor>> actors;
  const auto addIf = [&]<class A>(const scene::Extra& thing, std::type_identity<A>) {
    if (thing.visible) actors.push_back(std::make_unique<A>(setting));
  };
  addIf(show.trace, std::type_identity<TraceFigure>{});
  addIf(show.cones, std::type_identity<ConesFigure>{});
  addIf(show.mainAxis, std::type_identity<MainAxisFigure>{});
  addIf(show.theta, std::type_identity<ThetaFigure>{});
  addIf(show.decomposition, std::type_identity<DecompositionFigure>{});
  addIf(show.components, std::type_identity<ComponentsFigure>{});
  addIf(show.spaceAxes, std::type_identity<SpaceAxesFigure>{});
  addIf(show.polhodes, std::type_identity<PolhodesFigure>{});
  addIf(show.binet, std::type_identity<BinetFigure>{});
  return actors;
}

}  // namespace poinsot::stage
