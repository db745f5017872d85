// SPDX-License-Identifier: Apache-2.0
#include "physics/catalogue.h"
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"
#include "scene/keys/tensor_text.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kProducts{.least = kLeastMoment, .most = kMostMoment, .ofSize = true};  // products of inertia
constexpr Range kDensities{.least = 1e-30, .most = 1e30};
constexpr Range kTurns{.least = -360, .most = 360, .unit = "deg"};

template <class F>
Put intoPart(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.body.parts, i)); });
}

template <class F>
Put intoPoint(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.body.points, i)); });
}

std::vector<std::string_view> catalogueWords() {
  std::vector<std::string_view> words;
  for (const physics::CatalogueBody& body : physics::catalogue()) words.push_back(body.name);
  return words;
}

std::vector<Key> momentKeys() {
  return {
      {.path = "body.principal_moments",
       .type = kVector,
       .dimension = kMomentOfInertia,
       .range = kMoments,
       .example = "[1.0, 2.0, 2.5]",
       .help =
           "Moments of inertia about the body's principal axes, in any order; none above the sum of the "
           "others. About the centre of mass if the body has a mass (see moments_about), else about the point "
           "that stands still. This, or inertia, or shape with its keys, or catalogue, or parts and point masses.",
       .advice = nearestMomentsAdvice,
       .put = into([](Draft& d) { return &d.body.moments; })},
      {.path = "body.inertia",
       .type = kMatrix,
       .dimension = kMomentOfInertia,
       .range = kProducts,
       .example = "[[2, 0.1, 0], [0.1, 3, 0], [0, 0, 4]]",
       .help =
           "Inertia tensor in body axes, about the centre of mass if the body has a mass (see moments_about), "
           "else about the point that stands still. Off the diagonal stand -(sum of m x y), -(sum of m x z) and "
           "-(sum of m y z), as in URDF, MuJoCo and SolidWorks' negative tensor notation. Aerospace tables and "
           "many CAD sheets print +(sum of m x y): turn the sign.",
       .put = into([](Draft& d) { return &d.body.inertia; })},
      {.path = "body.centre_of_mass",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .fallback = "[0, 0, 0]",
       .example = "[0, 0, \"12 mm\"]",
       .help =
           "Where the centre of mass is, in body axes, of a body given by inertia or principal_moments and mass. "
           "In URDF: the xyz of the inertial origin.",
       .put = into([](Draft& d) { return &d.body.centre_B; })},
      {.path = "body.moments_about",
       .type = kWord,
       .words = {"centre_of_mass", "origin", "pivot"},
       .fallback = "\"centre_of_mass\"",
       .example = "\"pivot\"",
       .help = "The point that inertia or principal_moments are about, of a body with a mass. In URDF: the centre "
               "of mass. The origin is that of the body axes, which CAD calls the output coordinate system. The "
               "moments are then moved to the pivot (eq 14).",
       .put = into([](Draft& d) { return &d.body.momentsAbout; })},
      {.path = "body.catalogue",
       .type = kWord,
       .words = catalogueWords(),
       .example = "\"t_handle\"",
       .help = "A body of the real world, with its mass; see Catalogue below for where its numbers are from.",
       .put = into([](Draft& d) { return &d.body.catalogue; })},
  };
}

std::vector<Key> wholeKeys() {
  return {
      {.path = "body.mass",
       .dimension = kMass,
       .range = kMasses,
       .example = "\"320 g\"",
       .help = "Mass of the shape, or of the body whose inertia or principal_moments are given.",
       .put = into([](Draft& d) { return &d.body.whole.mass; })},
      {.path = "body.density",
       .dimension = kDensity,
       .range = kDensities,
       .example = "\"2.7 g/cm^3\"",
       .help = "In place of mass, of a shape that has a volume.",
       .put = into([](Draft& d) { return &d.body.whole.density; })},
      {.path = "body.pivot",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0, 0, \"-5 cm\"]",
       .help =
           "The point of the body that is held fixed, in body axes; without it, the body turns about its centre "
           "of mass. Needs a body with a mass.",
       .put = into([](Draft& d) { return &d.scene.body.pivot_B; })},
  };
}

ShapeTable wholeShape() {
  return {.path = "body",
          .of = [](Draft& d, std::size_t) -> ShapeDraft& { return d.body.whole.shape; },
          .shapeHelp =
              "Uniform solid or shell that sets the moments, with the keys of the shape and its mass; see "
              "Shapes below.",
          .sizeHelp = "Extents of the shape along the body's x, y and z axes; one number for all three."};
}

ShapeTable partShape() {
  return {.path = "body.part[]",
          .of = [](Draft& d, std::size_t i) -> ShapeDraft& { return elementAt(d.body.parts, i).shape; },
          .shapeHelp = "Uniform solid or shell, with the keys of the shape and its mass or density.",
          .sizeHelp = "Extents of the shape along its own x, y and z axes; one number for all three."};
}

std::vector<Key> partMassKeys() {
  return {
      {.path = "body.part[].mass",
       .dimension = kMass,
       .range = kMasses,
       .example = "\"320 g\"",
       .help = "Mass of the part.",
       .put = intoPart([](PieceDraft& p) { return &p.mass; })},
      {.path = "body.part[].density",
       .dimension = kDensity,
       .range = kDensities,
       .example = "\"2.7 g/cm^3\"",
       .help = "In place of mass, of a shape that has a volume.",
       .put = intoPart([](PieceDraft& p) { return &p.density; })},
  };
}

std::vector<Key> partPlaceKeys() {
  return {
      {.path = "body.part[].offset",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0, \"5 cm\", 0]",
       .help = "Where the part's origin is, in body axes; without it, at the body's origin.",
       .put = intoPart([](PieceDraft& p) { return &p.offset; })},
      {.path = "body.part[].rotation",
       .type = kQuaternion,
       .range = kQuaternionNorm,
       .example = "[1, 0, 0, 1]",
       .help =
           "Quaternion w, x, y, z taking the part's axes to body axes, normalised on reading; or axis and angle. "
           "Without either, the axes agree.",
       .put = intoPart([](PieceDraft& p) { return &p.rotation; })},
      {.path = "body.part[].axis",
       .type = kVector,
       .range = kPositions,
       .example = "[0, 0, 1]",
       .help = "Direction, of any length, that the part is turned about by angle.",
       .put = intoPart([](PieceDraft& p) { return &p.axis; })},
      {.path = "body.part[].angle",
       .dimension = kAngle,
       .range = kTurns,
       .example = "\"30 deg\"",
       .help = "How far the part is turned about axis, by the right-hand rule.",
       .put = intoPart([](PieceDraft& p) { return &p.angle; })},
  };
}

std::vector<Key> pointKeys() {
  return {
      {.path = "body.point_mass[].mass",
       .dimension = kMass,
       .range = kMasses,
       .example = "\"50 g\"",
       .help = "A mass without extent.",
       .put = intoPoint([](PointDraft& p) { return &p.mass; })},
      {.path = "body.point_mass[].position",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[\"10 cm\", 0, 0]",
       .help = "Where it is, in body axes.",
       .put = intoPoint([](PointDraft& p) { return &p.position; })},
  };
}

}  // namespace

std::vector<Key> bodyKeys() {
  return joined({momentKeys(), shapeKeys(wholeShape()), wholeKeys(), shapeKeys(partShape()), partMassKeys(),
                 partPlaceKeys(), pointKeys()});
}

}  // namespace poinsot::scene
