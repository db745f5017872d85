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
            .help = "Opacity: 0 hides nothing of what lies behind, 1 hides everything.",
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
            .help =
                "Number of polhodes that are drawn between the separatrix and the axis of the least moment. The "
                "same number is drawn between the separatrix and the axis of the largest moment.",
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
          "The two cones of a free body. omega draws the body cone in the body and the space cone, around the "
          "angular momentum L, in space. The body cone rolls on the space cone, and they touch along omega. The "
          "cones of a symmetric top are circular. Those of other bodies pass through the polhode and the "
          "herpolhode, and are drawn by lines along their sides. Their space cone need not close, and is drawn "
          "for "
          "half a turn before and after the present.",
          [](ShownFigures & f) -> auto& { return f.cones.visible; }),
      key.scale(
          "Factor on the length of the cones' sides. If the factor is 1, the sides are three quarters as long as "
          "omega.",
          [](ShownFigures & f) -> auto& { return f.cones.scale; }),
      key.opacity(
          "0.22", [](ShownFigures & f) -> auto& { return f.cones.opacity; }),
  };
}

std::vector<Key> decompositionKeys(const ShowTable& table) {
  const FigureKeys key(table, "decomposition");
  return {
      key.visible(
          "The parallelogram that splits omega of a free symmetric top into omega_p along L and -Omega_p k along "
          "the axis.",
          [](ShownFigures & f) -> auto& { return f.decomposition.visible; }),
      key.scale(
          "Factor on the size of the parallelogram. If the factor is not 1, the parallelogram's corner is not at "
          "the tip of omega.",
          [](ShownFigures & f) -> auto& { return f.decomposition.scale; }),
  };
}

std::vector<Key> triadKeys(const ShowTable& table) {
  const FigureKeys triad(table, "triad"), parts(table, "L_parts");
  return {
      triad.visible(
          "The axes i, j and k of a free symmetric top. The axis k is the axis of symmetry, i lies in the plane "
          "of "
          "L and k on the side of L, and j is perpendicular to this plane. Unlike e1 and e2, the axes i and j do "
          "not turn with the body, but go round L with k.",
          [](ShownFigures & f) -> auto& { return f.triad.visible; }),
      triad.scale(
          "Factor on the length of the axes.", [](ShownFigures & f) -> auto& { return f.triad.scale; }),
      triad.flag(
          "components", true, "The components omega_1 along i and omega_3 along k, whose sum is omega.",
          [](ShownFigures & f) -> auto& { return f.triad.components; }),
      parts.visible(
          "The two parts of L of a free symmetric top, head to tail: I1 omega along omega, and (I3 - I1) omega_3 "
          "k "
          "along the axis. The second part points along k for a flat body, and against k for a long one.",
          [](ShownFigures & f) -> auto& { return f.LParts.visible; }),
      parts.scale(
          "Factor on the length of the two parts. If the factor is not 1, they do not end at the tip of L.",
          [](ShownFigures & f) -> auto& { return f.LParts.scale; }),
  };
}

std::vector<Key> angleKeys(const ShowTable& table) {
  const FigureKeys axis(table, "main_axis"), theta(table, "theta");
  return {
      axis.visible(
          "The axis k of the body. It is the axis of symmetry or, without symmetry, the principal axis that the "
          "body spins about most at the start.",
          [](ShownFigures & f) -> auto& { return f.mainAxis.visible; }),
      axis.scale(
          "Factor on the length of the axis.", [](ShownFigures & f) -> auto& { return f.mainAxis.scale; }),
      theta.visible(
          "The angle theta between the body's axis k and the angular momentum L. Under gravity, it is the angle "
          "between k and the vertical.",
          [](ShownFigures & f) -> auto& { return f.theta.visible; }),
      theta.scale(
          "Factor on the radius of the angle's arc.", [](ShownFigures & f) -> auto& { return f.theta.scale; }),
  };
}

std::vector<Key> traceKeys(const ShowTable& table) {
  const FigureKeys key(table, "trace");
  return {
      key.visible(
          "The path of one point of the body. The path lies on a sphere, whose centre is the point that the body "
          "turns about.",
          [](ShownFigures & f) -> auto& { return f.trace.visible; }),
      key.scale(
          "Factor on the sphere's radius, if no point is given.",
          [](ShownFigures & f) -> auto& { return f.trace.scale; }),
      key.position(
          "point", "[0, 0, 0.5]",
          "Point of the body whose path is drawn, in body axes. The default is a point on the axis k beyond the "
          "body. For a thrown body, the default is the body's end.",
          [](ShownFigures & f) -> auto& { return f.trace.point_B; }),
      key.opacity(
          "0.06", [](ShownFigures & f) -> auto& { return f.trace.opacity; }),
      key.flag(
          "future", true, "Whether the part of the path that is still to come is also drawn, as a faint line.",
          [](ShownFigures & f) -> auto& { return f.trace.future; }),
  };
}

std::vector<Key> axesKeys(const ShowTable& table) {
  const FigureKeys parts(table, "components"), axes(table, "space_axes");
  return {
      parts.visible(
          "The components of omega along the principal axes, and the box whose diagonal is omega.",
          [](ShownFigures & f) -> auto& { return f.components.visible; }),
      parts.scale(
          "Factor on the size of the components and their box. If the factor is not 1, the box's corner is not at "
          "the tip of omega.",
          [](ShownFigures & f) -> auto& { return f.components.scale; }),
      axes.visible(
          "The axes x, y, z of space, at rest.", [](ShownFigures & f) -> auto& { return f.spaceAxes.visible; }),
      axes.scale(
          "Factor on the length of the axes.", [](ShownFigures & f) -> auto& { return f.spaceAxes.scale; }),
  };
}

std::vector<Key> polhodeKeys(const ShowTable& table) {
  const FigureKeys key(table, "polhodes"), binet(table, "binet");
  return {
      key.visible(
          "Other polhodes that a free body of the same energy can have, drawn on the ellipsoid. The separatrix, "
          "which divides the two kinds of polhode, is drawn too.",
          [](ShownFigures & f) -> auto& { return f.polhodes.visible; }),
      key.count(
          "4", [](ShownFigures & f) -> auto& { return f.polhodes.count; }),
      binet.visible(
          "Binet's construction for a free body. It consists of the momentum sphere |m| = L and the energy "
          "ellipsoid, both fixed in the body. The path of L along the intersection of the two is drawn too.",
          [](ShownFigures & f) -> auto& { return f.binet.visible; }),
      binet.opacity(
          "0.12", [](ShownFigures & f) -> auto& { return f.binet.opacity; }),
      binet.count(
          "4", [](ShownFigures & f) -> auto& { return f.binet.count; }),
      binet.flag(
          "area", false,
          "The part of the momentum sphere that the polhode encloses. Its solid angle is the geometric phase of "
          "one "
          "period of the polhode, which `info` prints.",
          [](ShownFigures & f) -> auto& { return f.binet.area; }),
  };
}

std::vector<Key> vectorKeys(const ShowTable& table) {
  const FigureKeys torque(table, "torque"), forces(table, "forces"), plane(table, "plane_of_L");
  return {
      torque.visible(
          "The torque on the body: gravity, given torques, forces at points and drag together.",
          [](ShownFigures & f) -> auto& { return f.torque.visible; }),
      torque.scale(
          "Factor on the length of the torque's arrow. The length is relative to the largest torque of the film.",
          [](ShownFigures & f) -> auto& { return f.torque.scale; }),
      forces.flag(
          "visible", true,
          "An arrow for each force of [[motion.force]], at its point of the body, while the force acts.",
          [](ShownFigures & f) -> auto& { return f.forces.visible; }),
      forces.scale(
          "Factor on the lengths of the forces' arrows. The lengths are relative to the largest of the forces.",
          [](ShownFigures & f) -> auto& { return f.forces.scale; }),
      forces.flag(
          "arms", false,
          "An arrow r to the point of each force, while the force acts. It starts at the point that the body "
          "turns about, so that r x F is the force's torque.",
          [](ShownFigures & f) -> auto& { return f.forces.arms; }),
      plane.visible(
          "The plane that contains L and omega. The axis of a symmetric top lies in this plane too.",
          [](ShownFigures & f) -> auto& { return f.planeOfL.visible; }),
      plane.scale(
          "Factor on the plane's size.", [](ShownFigures & f) -> auto& { return f.planeOfL.scale; }),
      plane.opacity(
          "0.12", [](ShownFigures & f) -> auto& { return f.planeOfL.opacity; }),
  };
}

std::vector<Key> ghostKeys(const ShowTable& table) {
  const FigureKeys key(table, "ghosts");
  return {
      key.visible(
          "Pale copies of the body at other times, as in a stroboscopic picture.",
          [](ShownFigures & f) -> auto& { return f.ghosts.visible; }),
      key.times(
          "[0, 0.5, 1]",
          "Film times at which the copies show the body. By default, `count` copies are spread evenly over the "
          "film.",
          [](ShownFigures & f) -> auto& { return f.ghosts.times_s; }),
      key.number(
          "count", {.least = 1, .most = 60}, "5", "8", "Number of copies, if no times are given.",
          [](ShownFigures & f) -> auto& { return f.ghosts.count; }),
      key.share(
          "strength", "0.35",
          "Strength of the colours of the pale copies: 0 is the colour of the paper, 1 is the colour of the body.",
          [](ShownFigures & f) -> auto& { return f.ghosts.strength; }),
      key.shift(
          "step", "[1.1, 0, 0]",
          "Shift from each copy of the body to the next. The three numbers are the shifts to the right, up and "
          "nearer, in units of the body's longest extent. The body itself comes first. The copies of a thrown "
          "body are not shifted, because each copy is where the body is at that time.",
          [](ShownFigures & f) -> auto& { return f.ghosts.step; }),
  };
}

std::vector<Key> flightKeys(const ShowTable& table) {
  const FigureKeys key(table, "flight"), total(table, "total_L");
  return {
      key.flag(
          "visible", true,
          "The flight of a thrown body ([motion.flight]), in views that are at rest in space. If true, the body "
          "moves along the path of its centre of mass, and this path is drawn. Poinsot's construction is then "
          "hidden unless the scene turns it on. If false, the picture moves with the centre of mass.",
          [](ShownFigures & f) -> auto& { return f.flight.visible; }),
      {.path = table.path + ".flight.scale",
       .range = {.least = 1e-6, .most = 100},
       .words = {"auto"},
       .fallback = "\"auto\"",
       .example = "0.2",
       .help = "Factor on the lengths of a thrown body's path. If the factor is not 1, the path and the body have "
               "different scales, and the arrow R to motion.flight.point has both. `auto` is 1 if the body is "
               "then large enough to be seen. Otherwise, `auto` shortens the path until the body can be seen.",
       .put = key.put([](ShownFigures & f) -> auto& { return f.flight.scale; })},
      key.flag(
          "position", true,
          "The arrow R from the origin to the centre of mass, or to the point motion.flight.point if the scene "
          "gives it.",
          [](ShownFigures & f) -> auto& { return f.flight.position; }),
      key.flag(
          "velocity", true,
          "The velocity V of the centre of mass, or of the point motion.flight.point if the scene gives it.",
          [](ShownFigures & f) -> auto& { return f.flight.velocity; }),
      key.flag(
          "weight", false,
          "The force of gravity M g, as an arrow. Only the arrow's direction counts, because its length has no "
          "meaning.",
          [](ShownFigures & f) -> auto& { return f.flight.weight; }),
      total.visible(
          "The angular momentum of a thrown body about the origin, and its two parts. One part is R x P of the "
          "centre of mass, and the other part is L. The three arrows start at the origin, in the scale of L. The "
          "body must have a mass.",
          [](ShownFigures & f) -> auto& { return f.totalL.visible; }),
      total.scale(
          "Factor on the length of the arrows that show.total_L draws. If the factor is not 1, these arrows are "
          "not in the scale of L.",
          [](ShownFigures & f) -> auto& { return f.totalL.scale; }),
      total.flag(
          "torque", false, "The torque of gravity about the origin, R x M g.",
          [](ShownFigures & f) -> auto& { return f.totalL.torque; }),
  };
}

std::vector<Key> tableKeys(const ShowTable& table) {
  const FigureKeys key(table, "table");
  return {
      key.flag(
          "visible", true,
          "The table on which a cone rolls ([motion.rolling]), with the line of contact and the circle on which "
          "the "
          "base touches the table.",
          [](ShownFigures & f) -> auto& { return f.table.visible; }),
      key.scale(
          "Factor on the table's size.", [](ShownFigures & f) -> auto& { return f.table.scale; }),
  };
}

}  // namespace

std::vector<Key> figureKeys(const ShowTable& table) {
  return joined({coneKeys(table), decompositionKeys(table), triadKeys(table), angleKeys(table), axesKeys(table),
                 polhodeKeys(table), traceKeys(table), vectorKeys(table), ghostKeys(table), flightKeys(table),
                 tableKeys(table)});
}

}  // namespace poinsot::scene
