// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "scene/assembly/scene_folder.h"
#include "scene/keys/draft.h"
#include "scene/keys/findings.h"
#include "scene/shapes.h"

namespace poinsot::scene {

/// What a shape's keys describe.
using Figure = std::variant<physics::Solid, std::shared_ptr<const geometry::Mesh>>;

/// The same as a part to draw, of 1 kg.
Part asPart(const Figure& figure);

/// Makes the figure that the shape keys of one table describe, or says which of them is missing, too many or
/// impossible.
class ShapeReader {
 public:
  /// `table`: "body", "body.part[2]", "show.body".
  ShapeReader(const ShapeDraft& shape, std::string table, Findings& findings, const SceneFolder& folder)
      : shape_(shape), table_(std::move(table)), findings_(findings), folder_(folder) {}

  /// Empty where a problem was found, now or by a key's own check.
  std::optional<Figure> figure();

  /// Whether any key of a shape is given, valid or not.
  bool given() const;

  /// Whether some key says how large the shape is.
  bool sized() const;

  /// Where to report that the whole shape cannot be: the first of its lengths, else the shape.
  std::string lengthPath() const;

 private:
  const NamedShape& kind() const { return namedShapes()[static_cast<std::size_t>(*shape_.word)]; }
  std::string path(std::string_view name) const { return table_ + "." + std::string(name); }
  bool has(std::string_view name) const { return findings_.has(path(name)); }
  const KeyNames& nearestWay() const;
  std::string lastPath() const;
  bool keysFit();
  bool refuseForeign(const KeyNames& way);
  bool refuseMissing(const KeyNames& way);
  bool sizeFits();
  std::optional<Figure> solid();
  std::optional<Figure> mesh();

  const ShapeDraft& shape_;
  std::string table_;
  Findings& findings_;
  const SceneFolder& folder_;
};

/// Whether `size` may have these extents.
bool extentsSuit(const NamedShape& kind, const std::vector<double>& size);

}  // namespace poinsot::scene
