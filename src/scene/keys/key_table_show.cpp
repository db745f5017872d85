// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

constexpr Range kScale{.least = 0.01, .most = 100};
constexpr Range kOpacity{.least = 0, .most = 1};

Key visibleKey(std::string path, std::string_view help, Put put) {
  return {.path = std::move(path),
          .type = kBool,
          .fallback = "true",
          .example = "false",
          .help = help,
          .put = std::move(put)};
}

Key scaleKey(std::string path, std::string_view help, Put put) {
  return {.path = std::move(path),
          .range = kScale,
          .fallback = "1",
          .example = "1.5",
          .help = help,
          .put = std::move(put)};
}

Key opacityKey(std::string path, std::string_view fallback, Put put) {
  return {.path = std::move(path),
          .range = kOpacity,
          .fallback = fallback,
          .example = "0.3",
          .help = "Opacity: 0 hides nothing of what lies behind, 1 hides everything.",
          .put = std::move(put)};
}

std::vector<Key> pictureKeys() {
  return {
      {.path = "show.title",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .fallback = "\"\"",
       .example = "\"Tennis racket\"",
       .help = "Title at the top left of the picture. To use mathematics, write it between dollar signs and put "
               "the title in single quotes: 'About $\\hat{\\mathbf{e}}_2$'.",
       .isTex = true,
       .put = into([](Draft& d) { return &d.scene.show.title; })},
      {.path = "show.subtitle",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .fallback = "\"\"",
       .example = "'$I_1 < I_2 < I_3$'",
       .help = "One line under the title.",
       .isTex = true,
       .put = into([](Draft& d) { return &d.scene.show.subtitle; })},
      {.path = "show.views",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Whether the picture has panels that show the body. If false, the picture has only its plots.",
       .put = [](Draft& d, std::size_t, const Checked& value) { d.noViews = !std::get<bool>(value); }},
      {.path = "show.exaggerate_angles",
       .range = {.least = 1, .most = 1e9},
       .fallback = "1",
       .example = "100",
       .help =
           "Factor by which poinsot enlarges small angles in the picture, so that they can be seen. It "
           "enlarges the part of omega across the main axis of spin. The picture states this factor. Plots and "
           "read-outs have the true numbers.",
       .put = into([](Draft& d) { return &d.scene.show.exaggerateAngles; })},
  };
}

std::vector<Key> drawnBodyKeys() {
  return {
      {.path = "show.labels",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Whether the vectors and axes have names beside them. To remove a single name, give it an empty "
               "text in [label].",
       .put = into([](Draft& d) { return &d.scene.show.labels; })},
      {.path = "show.captions",
       .type = kBool,
       .example = "true",
       .help =
           "Whether the captions of the timeline are drawn. By default, they are drawn in films and stills, but "
           "not in figures for print. Subtitle files contain them in any case.",
       .put = into([](Draft& d) { return &d.scene.show.captions; })},
      visibleKey("show.body.visible", "The body itself.",
                 into([](Draft& d) { return &d.scene.show.body.visible; })),
      scaleKey("show.body.scale", "Factor on the body's drawn size.",
               into([](Draft& d) { return &d.scene.show.body.scale; })),
  };
}

std::vector<Key> drawnShapeKeys() {
  return shapeKeys(
      {.path = "show.body",
       .of = [](Draft& d, std::size_t) -> ShapeDraft& { return d.drawn; },
       .shapeHelp = "Shape that is drawn instead of body.shape, which sets the moments. If the scene gives "
                    "neither of the two, poinsot draws the uniform box that has the body's moments.",
       .sizeHelp =
           "Extents of the shape that is drawn. Only their proportions count. The default is body.size, if the "
           "scene gives it and it suits the shape. Otherwise, the shape has its usual proportions."});
}

std::vector<Key> drawnThingKeys() {
  return {
      visibleKey("show.principal_axes.visible", "The principal axes, fixed in the body.",
                 into([](Draft& d) { return &d.scene.show.principalAxes.visible; })),
      {.path = "show.principal_axes.axes",
       .type = kWords,
       .words = {"1", "2", "3"},
       .fallback = "[1, 2, 3]",
       .example = "[1, 3]",
       .help = "Numbers of the axes that are drawn.",
       .put = into([](Draft& d) { return &d.scene.show.principalAxes.axes; })},
      scaleKey("show.principal_axes.scale", "Factor on the length of the axes.",
               into([](Draft& d) { return &d.scene.show.principalAxes.scale; })),
      visibleKey("show.L.visible", "The angular momentum L, an arrow fixed in space.",
                 into([](Draft& d) { return &d.scene.show.L.visible; })),
      scaleKey("show.L.scale", "Factor on the arrow's length.",
               into([](Draft& d) { return &d.scene.show.L.scale; })),
      visibleKey("show.omega.visible", "The angular velocity omega, an arrow to the point of contact.",
                 into([](Draft& d) { return &d.scene.show.omega.visible; })),
      scaleKey("show.omega.scale",
               "Factor on the length of the arrow omega. If the factor is not 1, the arrow's tip is not at the "
               "point of contact.",
               into([](Draft& d) { return &d.scene.show.omega.scale; })),

      visibleKey("show.ellipsoid.visible", "Poinsot's energy ellipsoid, in the space of omega.",
                 into([](Draft& d) { return &d.scene.show.ellipsoid.visible; })),
      scaleKey("show.ellipsoid.scale",
               "Factor on the drawn size of the ellipsoid. The plane, the curves and the point of contact, which "
               "touch the ellipsoid, are scaled too.",
               into([](Draft& d) { return &d.scene.show.ellipsoid.scale; })),
      opacityKey("show.ellipsoid.opacity", "0.13", into([](Draft& d) { return &d.scene.show.ellipsoid.opacity; })),
      {.path = "show.ellipsoid.graticule",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Lines on the ellipsoid that make its rolling visible.",
       .put = into([](Draft& d) { return &d.scene.show.ellipsoid.graticule; })},

      visibleKey("show.plane.visible", "The invariable plane, on which the ellipsoid rolls.",
                 into([](Draft& d) { return &d.scene.show.plane.visible; })),
      opacityKey("show.plane.opacity", "0.16", into([](Draft& d) { return &d.scene.show.plane.opacity; })),
      {.path = "show.plane.grid",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Lines on the plane that show its scale.",
       .put = into([](Draft& d) { return &d.scene.show.plane.grid; })},

      visibleKey("show.contact.visible", "The point of contact: the tip of omega.",
                 into([](Draft& d) { return &d.scene.show.contact.visible; })),
      scaleKey("show.contact.scale", "Factor on the point's drawn size.",
               into([](Draft& d) { return &d.scene.show.contact.scale; })),
      visibleKey("show.polhode.visible", "The path of the point of contact on the ellipsoid.",
                 into([](Draft& d) { return &d.scene.show.polhode.visible; })),
      visibleKey("show.herpolhode.visible", "The path of the point of contact on the plane.",
                 into([](Draft& d) { return &d.scene.show.herpolhode.visible; })),
      {.path = "show.herpolhode.future",
       .type = kBool,
       .fallback = "true",
       .example = "false",
       .help = "Whether the part of the path that is still to come is also drawn, as a faint line.",
       .put = into([](Draft& d) { return &d.scene.show.herpolhode.future; })},
      visibleKey("show.height.visible", "The constant height of the centre above the plane, 2T/|L|.",
                 into([](Draft& d) { return &d.scene.show.height.visible; })),
  };
}

std::vector<Key> ownFigureKeys() {
  return figureKeys({.path = "show", .of = [](Draft& d, std::size_t) -> Show& { return d.scene.show; }});
}

}  // namespace

std::vector<Key> showKeys() {
  return joined({pictureKeys(), drawnBodyKeys(), drawnShapeKeys(), drawnThingKeys(), ownFigureKeys()});
}

std::vector<Key> shownKeys() { return joined({drawnBodyKeys(), drawnThingKeys(), ownFigureKeys()}); }

}  // namespace poinsot::scene
