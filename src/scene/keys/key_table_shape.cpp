// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"
#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

template <class F>
Put intoShape(const ShapeTable& table, F place) {
  return [of = table.of, place](Draft& draft, std::size_t element, const Checked& value) {
    assign(*place(of(draft, element)), value);
  };
}

Key lengthKey(const ShapeTable& table, const LengthKey& key) {
  return {.path = table.path + "." + std::string(key.name),
          .dimension = kLength,
          .range = key.signedLength ? kPositions : kExtent,
          .example = key.example,
          .help = key.help,
          .put = intoShape(table, [name = key.name](ShapeDraft& shape) { return &shape.lengths[name]; })};
}

std::vector<Key> outlineKeys(const ShapeTable& table) {
  return {{.path = table.path + ".shape",
           .type = kWord,
           .words = shapeWords(),
           .example = "\"box\"",
           .help = table.shapeHelp,
           .put = intoShape(table, [](ShapeDraft& shape) { return &shape.word; })},
          {.path = table.path + ".size",
           .type = kExtents,
           .dimension = kLength,
           .range = kExtent,
           .example = "[0.3, 0.2, 0.05]",
           .help = table.sizeHelp,
           .put = intoShape(table, [](ShapeDraft& shape) { return &shape.size; })}};
}

std::vector<Key> wingAndFileKeys(const ShapeTable& table) {
  return {{.path = table.path + ".wing",
           .type = kVector,
           .dimension = kLength,
           .range = kExtent,
           .example = "[0.012, 0.002, 0.009]",
           .help = "Extents of one wing of a wing nut.",
           .put = intoShape(table, [](ShapeDraft& shape) { return &shape.wing; })},
          {.path = table.path + ".file",
           .type = kText,
           .range = kPathLength,
           .example = "\"body.stl\"",
           .help = "Mesh file of type OBJ, STL or PLY. The file must be in the scene's folder or below it.",
           .put = intoShape(table, [](ShapeDraft& shape) { return &shape.file; })},
          {.path = table.path + ".file_unit",
           .dimension = kLength,
           .range = kExtent,
           .example = "\"1 mm\"",
           .help = "Unit of the numbers in the mesh file. By default, metres.",
           .put = intoShape(table, [](ShapeDraft& shape) { return &shape.fileUnit_m; })}};
}

}  // namespace

std::vector<Key> shapeKeys(const ShapeTable& table) {
  std::vector<Key> lengths;
  for (const LengthKey& key : lengthKeys()) lengths.push_back(lengthKey(table, key));
  return joined({outlineKeys(table), std::move(lengths), wingAndFileKeys(table)});
}

}  // namespace poinsot::scene
