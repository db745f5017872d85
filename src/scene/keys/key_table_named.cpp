// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kNameLength{.least = 0, .most = 80};
constexpr Range kFactors{.least = 0.01, .most = 100};
constexpr Range kComponents{.least = 1e-12, .most = 1e12, .ofSize = true};

template <class F>
Put intoVector(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.vectors, i)); });
}

template <class F>
Put intoAngle(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.angles, i)); });
}

std::vector<Key> vectorKeys() {
  return {
      {.path = "vector[].name",
       .type = kText,
       .range = kNameLength,
       .example = "'$\\mathbf{r}$'",
       .help = "Text at the arrow's tip.",
       .isTex = true,
       .put = intoVector([](VectorDraft& v) { return &v.name; })},
      {.path = "vector[].components",
       .type = kVector,
       .range = kComponents,
       .example = "[0, 0, 1]",
       .help = "Direction of the arrow, in the axes that `frame` names. The arrow's length is the width of the "
               "body times `scale`.",
       .put = intoVector([](VectorDraft& v) { return &v.components; })},
      {.path = "vector[].frame",
       .type = kWord,
       .words = {"space", "body", "principal", "precession", "own"},
       .example = "\"body\"",
       .help =
           "Axes in which `components` gives the arrow. The default is the axes of space. `precession` means the "
           "axes i, j, k of a free symmetric top, which show.triad draws, and `own` means [body.own_axes].",
       .put = intoVector([](VectorDraft& v) { return &v.frame; })},
      {.path = "vector[].position_of",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0.3, 0, 0.1]",
       .help = "Point of the body to which the arrow leads. The arrow starts at the point that the body turns "
               "about, or at motion.flight.point if the scene gives it. Use position_of instead of `components`.",
       .put = intoVector([](VectorDraft& v) { return &v.position; })},
      {.path = "vector[].velocity_of",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0.3, 0, 0.1]",
       .help = "Point of the body whose velocity the arrow shows. The arrow starts at this point. Use velocity_of "
               "instead of `components`.",
       .put = intoVector([](VectorDraft& v) { return &v.velocity; })},
      {.path = "vector[].scale",
       .range = kFactors,
       .example = "1.5",
       .help = "Factor on the arrow's length.",
       .put = intoVector([](VectorDraft& v) { return &v.scale; })},
      {.path = "vector[].color",
       .type = kWord,
       .words = {"vector", "ink", "L", "omega", "body", "axes", "torque"},
       .example = "\"omega\"",
       .help = "Colour of the arrow, which is one of the colours of [style.colors]. The word `axes` stands for "
               "the colour `axis`.",
       .put = intoVector([](VectorDraft& v) { return &v.color; })},
  };
}

std::vector<Key> angleKeys() {
  return {
      {.path = "angle[].between",
       .type = kWords,
       .words = {"L", "omega", "torque", "axis", "e1", "e2", "e3", "x", "y", "z"},
       .example = "[\"L\", \"omega\"]",
       .help = "The two directions that enclose the angle. The word `axis` stands for the axis that "
               "show.main_axis draws.",
       .put = intoAngle([](AngleDraft& a) { return &a.between; })},
      {.path = "angle[].name",
       .type = kText,
       .range = kNameLength,
       .example = "'$\\alpha$'",
       .help = "Text at the angle's arc.",
       .isTex = true,
       .put = intoAngle([](AngleDraft& a) { return &a.name; })},
      {.path = "angle[].scale",
       .range = kFactors,
       .example = "1.5",
       .help = "Factor on the radius of the arc.",
       .put = intoAngle([](AngleDraft& a) { return &a.scale; })},
  };
}

}  // namespace

std::vector<Key> namedKeys() { return joined({vectorKeys(), angleKeys()}); }

}  // namespace poinsot::scene
