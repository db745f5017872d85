// SPDX-License-Identifier: Apache-2.0
#include "physics/catalogue.h"
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"
#include "scene/keys/tensor_text.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kProducts{.least = kLeastMoment, .most = kMostMoment, .ofSize = true};  // for products of inertia
constexpr Range kDensities{.least = 1e-30, .most = 1e30};

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
       .help = "Moments of inertia about the body's principal axes, in any order. No moment may exceed the sum of "
               "the other two. If the body has a mass, the moments are about the centre of mass unless "
               "moments_about names another point. Without a mass, the moments are about the fixed point of the "
               "motion. A scene gives its body by principal_moments, by inertia, by shape with its keys, by "
               "catalogue, or by parts and point masses.",
       .advice = nearestMomentsAdvice,
       .put = into([](Draft& d) { return &d.body.moments; })},
      {.path = "body.inertia",
       .type = kMatrix,
       .dimension = kMomentOfInertia,
       .range = kProducts,
       .example = "[[2, 0.1, 0], [0.1, 3, 0], [0, 0, 4]]",
       .help =
           "Inertia tensor of the body in body axes. If the body has a mass, the tensor is about the centre of "
           "mass unless moments_about names another point. Without a mass, the tensor is about the fixed point of "
           "the motion. The off-diagonal elements are -(sum of m x y), -(sum of m x z) and -(sum of m y z). URDF, "
           "MuJoCo and SolidWorks' negative tensor notation have the same signs. Aerospace tables and many CAD "
           "sheets print +(sum of m x y), so reverse the signs of their off-diagonal elements.",
       .put = into([](Draft& d) { return &d.body.inertia; })},
      {.path = "body.centre_of_mass",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .fallback = "[0, 0, 0]",
       .example = "[0, 0, \"12 mm\"]",
       .help = "Position of the body's centre of mass in body axes. Only a body that is given by mass and by "
               "inertia or principal_moments can have this key. In a URDF file, this position is the xyz of the "
               "inertial origin.",
       .put = into([](Draft& d) { return &d.body.centre_B; })},
      {.path = "body.moments_about",
       .type = kWord,
       .words = {"centre_of_mass", "origin", "pivot"},
       .fallback = "\"centre_of_mass\"",
       .example = "\"pivot\"",
       .help = "The point that inertia or principal_moments are about, if the body has a mass. In a URDF file, "
               "this point is the centre of mass. `origin` is the origin of the body axes, which CAD programs "
               "call the output coordinate system. poinsot moves the moments from this point to the pivot by eq "
               "14 of docs/physics.md.",
       .put = into([](Draft& d) { return &d.body.momentsAbout; })},
      {.path = "body.catalogue",
       .type = kWord,
       .words = catalogueWords(),
       .example = "\"t_handle\"",
       .help = "Name of a real body, which sets the body's mass and moments. The section Catalogue of "
               "docs/scene.md gives the source of each number.",
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
       .help = "Density of a shape that has a volume. Use the key density instead of mass.",
       .put = into([](Draft& d) { return &d.body.whole.density; })},
      {.path = "body.pivot",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0, 0, \"-5 cm\"]",
       .help = "Point of the body that is held fixed in space, in body axes. Without a pivot, the body turns "
               "about its centre of mass. Only a body with a mass can have a pivot.",
       .put = into([](Draft& d) { return &d.scene.body.pivot_B; })},
  };
}

std::vector<Key> ownAxesKeys() {
  return {
      {.path = "body.own_axes.rotation",
       .type = kQuaternion,
       .range = kQuaternionNorm,
       .example = "[1, 0, 0, 1]",
       .help = "Axes of your own, in which `info` and a note also give the inertia tensor (eq 15 and 16 of "
               "docs/physics.md). The quaternion w, x, y, z takes your axes to the body's axes. You can give the "
               "axes by roll_pitch_yaw or by x and y instead.",
       .put = into([](Draft& d) { return &d.body.ownAxes.rotation; })},
      {.path = "body.own_axes.roll_pitch_yaw",
       .type = kVector,
       .dimension = kAngle,
       .range = kFullTurns,
       .example = "[0, 0, \"30 deg\"]",
       .help = "Roll, pitch and yaw of your axes from the body's axes. From the body's axes, your axes are turned "
               "by the yaw about z, then by the pitch about their new y, then by the roll about their newest x.",
       .put = into([](Draft& d) { return &d.body.ownAxes.rollPitchYaw; })},
      {.path = "body.own_axes.x",
       .type = kVector,
       .range = kPositions,
       .example = "[1, 1, 0]",
       .help = "Direction of your x axis in body axes, of any length. It needs y.",
       .put = into([](Draft& d) { return &d.body.ownAxes.x; })},
      {.path = "body.own_axes.y",
       .type = kVector,
       .range = kPositions,
       .example = "[0, 1, 0]",
       .help = "Direction in body axes, of any length, towards which your y axis points. The part of it along x "
               "does not count. Your z axis is at right angles to both, by the right-hand rule.",
       .put = into([](Draft& d) { return &d.body.ownAxes.y; })},
  };
}

ShapeTable wholeShape() {
  return {.path = "body",
          .of = [](Draft& d, std::size_t) -> ShapeDraft& { return d.body.whole.shape; },
          .shapeHelp =
              "Uniform solid or shell that sets the body's moments. A shape also needs its own keys, such as size "
              "or radius, and mass or density. The section Shapes of docs/scene.md lists the keys of each shape.",
          .sizeHelp = "Extents of the shape along the body's x, y and z axes. One number sets all three."};
}

ShapeTable partShape() {
  return {.path = "body.part[]",
          .of = [](Draft& d, std::size_t i) -> ShapeDraft& { return elementAt(d.body.parts, i).shape; },
          .shapeHelp =
              "Uniform solid or shell that is one part of the body. The part also needs the keys of its shape, "
              "such as size or radius, and mass or density.",
          .sizeHelp = "Extents of the shape along its own x, y and z axes. One number sets all three."};
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
       .help = "Density of a shape that has a volume. Use the key density instead of mass.",
       .put = intoPart([](PieceDraft& p) { return &p.density; })},
  };
}

/// Table whose elements are placed in body axes.
struct PlacedTable {
  std::string path;
  PieceDraft& (*of)(Draft&, std::size_t element);
};

template <class F>
Put intoPlaced(const PlacedTable& table, F place) {
  return into([of = table.of, place](Draft& d, std::size_t i) { return place(of(d, i)); });
}

std::vector<Key> placeKeys(const PlacedTable& table) {
  return {
      {.path = table.path + ".offset",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[0, \"5 cm\", 0]",
       .help = "Position of the shape's origin in body axes. By default, this is the body's origin.",
       .put = intoPlaced(table, [](PieceDraft& p) { return &p.offset; })},
      {.path = table.path + ".rotation",
       .type = kQuaternion,
       .range = kQuaternionNorm,
       .example = "[1, 0, 0, 1]",
       .help = "Quaternion w, x, y, z that takes the shape's axes to body axes. The quaternion is normalised on "
               "reading. Instead of rotation, you can give the keys axis and angle. Without a rotation, the "
               "shape's axes are the body's axes.",
       .put = intoPlaced(table, [](PieceDraft& p) { return &p.rotation; })},
      {.path = table.path + ".axis",
       .type = kVector,
       .range = kPositions,
       .example = "[0, 0, 1]",
       .help = "Direction, of any length, about which the shape is turned by `angle`.",
       .put = intoPlaced(table, [](PieceDraft& p) { return &p.axis; })},
      {.path = table.path + ".angle",
       .dimension = kAngle,
       .range = kFullTurns,
       .example = "\"30 deg\"",
       .help = "Angle by which the shape is turned about `axis`, by the right-hand rule.",
       .put = intoPlaced(table, [](PieceDraft& p) { return &p.angle; })},
  };
}

ShapeTable markShape() {
  return {.path = "mark[]",
          .of = [](Draft& d, std::size_t i) -> ShapeDraft& { return elementAt(d.marks, i).piece.shape; },
          .shapeHelp =
              "Shape on the body that shows how the body has turned, such as the camera of a phone. It is "
              "drawn in its own colour and has no mass. The mark also needs the keys of its shape, such "
              "as size or radius. Let it stand out of the body a little.",
          .sizeHelp = "Extents of the shape along its own x, y and z axes. One number sets all three."};
}

std::vector<Key> pointKeys() {
  return {
      {.path = "body.point_mass[].mass",
       .dimension = kMass,
       .range = kMasses,
       .example = "\"50 g\"",
       .help = "Mass of the point, which has no extent.",
       .put = intoPoint([](PointDraft& p) { return &p.mass; })},
      {.path = "body.point_mass[].position",
       .type = kVector,
       .dimension = kLength,
       .range = kPositions,
       .example = "[\"10 cm\", 0, 0]",
       .help = "Position of the point in body axes.",
       .put = intoPoint([](PointDraft& p) { return &p.position; })},
  };
}

}  // namespace

std::vector<Key> bodyKeys() {
  const PlacedTable parts{"body.part[]",
                          [](Draft& d, std::size_t i) -> PieceDraft& { return elementAt(d.body.parts, i); }};
  return joined({momentKeys(), shapeKeys(wholeShape()), wholeKeys(), ownAxesKeys(), shapeKeys(partShape()),
                 partMassKeys(), placeKeys(parts), pointKeys()});
}

std::vector<Key> markKeys() {
  const PlacedTable marks{"mark[]",
                          [](Draft& d, std::size_t i) -> PieceDraft& { return elementAt(d.marks, i).piece; }};
  return joined({shapeKeys(markShape()),
                 placeKeys(marks),
                 {{.path = "mark[].color",
                   .type = kColor,
                   .example = "\"#CC6677\"",
                   .help = "Colour of the mark. The default is style.colors.mark.",
                   .put = into([](Draft& d, std::size_t i) { return &elementAt(d.marks, i).color; })}}});
}

}  // namespace poinsot::scene
