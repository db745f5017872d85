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

using Figure = std::variant<physics::Solid, std::shared_ptr<const geometry::Mesh>>;

/// Returns a figure as a part of the body that is only drawn. The part has a mass of 1 kg.
Part asPart(const Figure& figure);

/// Reader of the keys of a shape in one table. Makes the solid or mesh, or rejects wrong or missing keys.
class ShapeReader {
 public:
  /// @param table  path of the table, such as "body", "body.part[2]" or "show.body"
  ShapeReader(const ShapeDraft& shape, std::string table, Findings& findings, const SceneFolder& folder)
      : shape_(shape), table_(std::move(table)), findings_(findings), folder_(folder) {}

  /// Returns the solid or mesh. Returns nullopt if a key is wrong; the problem is then reported.
  std::optional<Figure> figure();

  /// Returns whether any key of the shape is given, valid or not.
  bool given() const;

  bool sized() const;

  /// Returns the path at which to report an impossible shape: its first length, or `shape` if no length is given.
  std::string lengthPath() const;

 private:
  const NamedShape& kind() const { return namedShapes()[static_cast<std::size_t>(*shape_.word)]; }
  std::string path(std::string_view name) const { return table_ + "." + std::string(name); }
  bool has(std::string_view name) const { return findings_.has(path(name)); }
  const KeyNames& nearestWay() const;
  std::string lastPath() const;
  bool keysFit();
  std::string lineFor(std::string_view name) const;
  std::string adviceFor(const KeyNames& foreign, const KeyNames& missing) const;
  KeyNames missingOf(const KeyNames& way) const;
  std::string adviceForMissing(const KeyNames& missing) const;
  bool isInCatalogue() const;
  bool refuseForeign(const KeyNames& way);
  bool refuseMissing(const KeyNames& way);
  bool sizeFits();
  std::optional<Figure> solid();
  std::optional<Figure> mesh();

  const ShapeDraft& shape_;
  std::string table_;
  Findings& findings_;
  const SceneFolder& folder_;
  bool hasAdvice_ = false;  ///< whether the advice for a key that is not allowed gives the missing key
};

bool extentsSuit(const NamedShape& kind, const std::vector<double>& size);

}  // namespace poinsot::scene
