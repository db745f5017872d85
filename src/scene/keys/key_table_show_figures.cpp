// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

class FigureKeys {
 public:
  FigureKeys(const ShowTable& table, std::string_view name)
      : table_(table), path_(table.path + "." + std::string(name)) {}

  template <class Place>
  Put put(Place place) const {
    return into([of = table_.of, place](Draft& d, std::size_t i) { return &place(of(d, i).figures); });
  }

  template <class Place>
  Key visible(std::string_view help, Place place) const {
    return {.path = path_ + ".visible",
            .type = kBool,
            .fallback = "false",
            .example = "true",
            .help = help,
            .put = put(place)};
  }

  template <class Place>
  Key scale(std::string_view help, Place place) const {
    return {.path = path_ + ".scale",
            .range = {.least = 0.01, .most = 100},
            .fallback = "1",
            .example = "1.5",
            .help = help,
            .put = put(place)};
  }

  template <class Place>
  Key opacity(std::string_view fallback, Place place) const {
    return {.path = path_ + ".opacity",
            .range = {.least = 0, .most = 1},
            .fallback = fallback,
            .example = "0.35",
            .help = "How much of what lies behind it hides: 0 nothing, 1 all.",
            .put = put(place)};
  }

  template <class Place>
  Key position(std::string_view name, std::string_view example, std::string_view help, Place place) const {
    return {.path = path_ + "." + std::string(name),
            .type = kVector,
            .dimension = kLength,
            .range = kPositions,
            .example = example,
            .help = help,
            .put = put(place)};
  }

  template <class Place>
  Key flag(std::string_view name, bool fallback, std::string_view help, Place place) const {
    return {.path = path_ + "." + std::string(name),
            .type = kBool,
            .fallback = fallback ? "true" : "false",
            .example = fallback ? "false" : "true",
            .help = help,
            .put = put(place)};
  }

  template <class Place>
  Key count(std::string_view fallback, Place place) const {
    return {.path = path_ + ".count",
            .type = kInteger,
            .range = {.least = 1, .most = 20},
            .fallback = fallback,
            .example = "6",
            .help = "How many polhodes between the separatrix and each of the two outer axes.",
            .put = put(place)};
  }

  template <class Place>
  Key times(std::string_view example, std::string_view help, Place place) const {
    return {.path = path_ + ".times",
            .type = kNumbers,
            .dimension = kTime,
            .range = {.least = 0, .most = usual(Limit::kDuration), .limit = Limit::kDuration},
            .example = example,
            .help = help,
            .put = put(place)};
  }

  template <class Place>
  Key number(std::string_view name, Range range, std::string_view fallback, std::string_view example,
             std::string_view help, Place place) const {
    return {.path = path_ + "." + std::string(name),
            .type = kInteger,
            .range = range,
            .fallback = fallback,
            .example = example,
            .help = help,
            .put = put(place)};
  }

  template <class Place>
  Key share(std::string_view name, std::string_view fallback, std::string_view help, Place place) const {
    return {.path = path_ + "." + std::string(name),
            .range = {.least = 0, .most = 1},
            .fallback = fallback,
            .example = "0.5",
            .help = help,
            .put = put(place)};
  }

  template <class Place>
  Key shift(std::string_view name, std::string_view example, std::string_view help, Place place) const {
    return {.path = path_ + "." + std::string(name),
            .type = kVector,
            .range = {.least = -20, .most = 20},
            .fallback = "[0.9, 0, 0]",
            .example = example,
            .help = help,
            .put = put(place)};
  }

 private:
  const ShowTable& table_;
  std::string path_;
};

std::vector<Key> coneKeys(const ShowTable& table) {
  const FigureKeys key(table, "cones");
  return {
      key.visible(
          "Of a free symmetric top: the body cone, fixed in the body about its axis, that rolls on the space "
          "cone about L; they touch along omega.",
          [](ShownFigures & f) -> auto& { return f.cones.visible; }),
      key.scale(
          "Factor on the length of their sides, by default three quarters of omega.",
          [](ShownFigures & f) -> auto& { return f.cones.scale; }),
      key.opacity(
          "0.22", [](ShownFigures & f) -> auto& { return f.cones.opacity; }),
  };
}

std::vector<Key> decompositionKeys(const ShowTable& table) {
  const FigureKeys key(table, "decomposition");
  return {
      key.visible(
          "Of a free symmetric top: the parallelogram that parts omega into omega_p, along L, and -Omega_p k, "
          "along the axis.",
          [](ShownFigures & f) -> auto& { return f.decomposition.visible; }),
      key.scale(
          "Factor on its size; other than 1, its corner leaves the tip of omega.",
          [](ShownFigures & f) -> auto& { return f.decomposition.scale; }),
  };
}

std::vector<Key> angleKeys(const ShowTable& table) {
  const FigureKeys axis(table, "main_axis"), theta(table, "theta");
  return {
      axis.visible(
          "The axis k: of symmetry, or the principal axis that the body spins about most at the start.",
          [](ShownFigures & f) -> auto& { return f.mainAxis.visible; }),
      axis.scale(
          "Factor on its length.", [](ShownFigures & f) -> auto& { return f.mainAxis.scale; }),
      theta.visible(
          "The angle theta between k and L; under gravity, between k and the vertical.",
          [](ShownFigures & f) -> auto& { return f.theta.visible; }),
      theta.scale(
          "Factor on the radius of its arc.", [](ShownFigures & f) -> auto& { return f.theta.scale; }),
  };
}

std::vector<Key> traceKeys(const ShowTable& table) {
  const FigureKeys key(table, "trace");
  return {
      key.visible(
          "The path of a point of the body, on a sphere about the point that the body turns about.",
          [](ShownFigures & f) -> auto& { return f.trace.visible; }),
      key.scale(
          "Factor on the sphere's radius, where no point is given.",
          [](ShownFigures & f) -> auto& { return f.trace.scale; }),
      key.position(
          "point", "[0, 0, 0.5]",
          "The point, in body axes. Without it: one on the axis k, beyond the body; of a thrown body, its end.",
          [](ShownFigures & f) -> auto& { return f.trace.point_B; }),
      key.opacity(
          "0.06", [](ShownFigures & f) -> auto& { return f.trace.opacity; }),
      key.flag(
          "future", true, "Whether the part not yet travelled is drawn too, faint.",
          [](ShownFigures & f) -> auto& { return f.trace.future; }),
  };
}

std::vector<Key> axesKeys(const ShowTable& table) {
  const FigureKeys parts(table, "components"), axes(table, "space_axes");
  return {
      parts.visible(
          "The components of omega along the principal axes, and the box of which omega is the diagonal.",
          [](ShownFigures & f) -> auto& { return f.components.visible; }),
      parts.scale(
          "Factor on their size; other than 1, the box's corner leaves the tip of omega.",
          [](ShownFigures & f) -> auto& { return f.components.scale; }),
      axes.visible(
          "The axes x, y, z of space, at rest.", [](ShownFigures & f) -> auto& { return f.spaceAxes.visible; }),
      axes.scale(
          "Factor on their length.", [](ShownFigures & f) -> auto& { return f.spaceAxes.scale; }),
  };
}

std::vector<Key> polhodeKeys(const ShowTable& table) {
  const FigureKeys key(table, "polhodes"), binet(table, "binet");
  return {
      key.visible(
          "Of a free body: other polhodes on the ellipsoid, of the same energy, and the separatrix between "
          "the two kinds.",
          [](ShownFigures & f) -> auto& { return f.polhodes.visible; }),
      key.count(
          "4", [](ShownFigures & f) -> auto& { return f.polhodes.count; }),
      binet.visible(
          "Of a free body: the momentum sphere |m| = L and the energy ellipsoid, fixed in the body, and the "
          "path of L along their intersection (Binet).",
          [](ShownFigures & f) -> auto& { return f.binet.visible; }),
      binet.opacity(
          "0.12", [](ShownFigures & f) -> auto& { return f.binet.opacity; }),
      binet.count(
          "4", [](ShownFigures & f) -> auto& { return f.binet.count; }),
  };
}

std::vector<Key> vectorKeys(const ShowTable& table) {
  const FigureKeys torque(table, "torque"), plane(table, "plane_of_L");
  return {
      torque.visible(
          "The torque on the body: gravity, given torques and drag together.",
          [](ShownFigures & f) -> auto& { return f.torque.visible; }),
      torque.scale(
          "Factor on its length, which is set by the longest of the film.",
          [](ShownFigures & f) -> auto& { return f.torque.scale; }),
      plane.visible(
          "The plane of L and omega; of a symmetric top, the axis lies in it too.",
          [](ShownFigures & f) -> auto& { return f.planeOfL.visible; }),
      plane.scale(
          "Factor on its size.", [](ShownFigures & f) -> auto& { return f.planeOfL.scale; }),
      plane.opacity(
          "0.12", [](ShownFigures & f) -> auto& { return f.planeOfL.opacity; }),
  };
}

std::vector<Key> ghostKeys(const ShowTable& table) {
  const FigureKeys key(table, "ghosts");
  return {
      key.visible(
          "The body as it is at other times, pale: a stroboscopic picture.",
          [](ShownFigures & f) -> auto& { return f.ghosts.visible; }),
      key.times(
          "[0, 0.5, 1]", "Film times of the poses; without them, `count` of them evenly over the film.",
          [](ShownFigures & f) -> auto& { return f.ghosts.times_s; }),
      key.number(
          "count", {.least = 1, .most = 60}, "5", "8", "How many poses there are, where no times are given.",
          [](ShownFigures & f) -> auto& { return f.ghosts.count; }),
      key.share(
          "strength", "0.35", "How strong their colours are: 0 as the paper, 1 as the body.",
          [](ShownFigures & f) -> auto& { return f.ghosts.strength; }),
      key.shift(
          "step", "[1.1, 0, 0]",
          "Where each pose stands from the one before, to the right, up and nearer, in the "
          "body's longest extents; the body itself stands first. Not of a body that flies, which is where it is "
          "then.",
          [](ShownFigures & f) -> auto& { return f.ghosts.step; }),
  };
}

std::vector<Key> flightKeys(const ShowTable& table) {
  const FigureKeys key(table, "flight"), total(table, "total_L");
  return {
      key.flag(
          "visible", true,
          "Of a thrown body ([motion.flight]), in views at rest in space: the body moves along, without Poinsot's "
          "construction unless that is asked for, on the path of its centre of mass, which is drawn. Without it a "
          "picture goes with the centre of mass.",
          [](ShownFigures & f) -> auto& { return f.flight.visible; }),
      {.path = table.path + ".flight.scale",
       .range = {.least = 1e-6, .most = 100},
       .words = {"auto"},
       .fallback = "\"auto\"",
       .example = "0.2",
       .help =
           "Factor on the lengths of the path; other than 1, it is not to the scale of the body. auto is 1 where "
           "the body can be seen then, else as much less as lets it be seen.",
       .put = key.put([](ShownFigures & f) -> auto& { return f.flight.scale; })},
      key.flag(
          "position", true, "The arrow R from the origin to the centre of mass.",
          [](ShownFigures & f) -> auto& { return f.flight.position; }),
      key.flag(
          "velocity", true, "The velocity V of the centre of mass.",
          [](ShownFigures & f) -> auto& { return f.flight.velocity; }),
      key.flag(
          "weight", false, "The force of gravity M g; only its direction counts.",
          [](ShownFigures & f) -> auto& { return f.flight.weight; }),
      total.visible(
          "Of a thrown body with a mass: its angular momentum about the origin and the two parts of it, R x P of "
          "the centre of mass and L, at the origin, in the scale of L.",
          [](ShownFigures & f) -> auto& { return f.totalL.visible; }),
      total.scale(
          "Factor on their length; other than 1, they are not in the scale of L.",
          [](ShownFigures & f) -> auto& { return f.totalL.scale; }),
      total.flag(
          "torque", false, "The torque of gravity about the origin, R x M g.",
          [](ShownFigures & f) -> auto& { return f.totalL.torque; }),
  };
}

}  // namespace

std::vector<Key> figureKeys(const ShowTable& table) {
  return joined({coneKeys(table), decompositionKeys(table), angleKeys(table), axesKeys(table), polhodeKeys(table),
                 traceKeys(table), vectorKeys(table), ghostKeys(table), flightKeys(table)});
}

}  // namespace poinsot::scene
