// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/unaligned_types.h"
#include "scene/assembly/shape_reader.h"

namespace poinsot::scene {

/// Part of the body with its mass properties, in body axes B.
struct Piece {
  Part part;
  physics::MassProperties mass;
};

/// Reader of the keys in [body] or one [[body.part]] for a part of the body: shape, mass and position.
class PieceReader {
 public:
  /// @param table  path of the table, such as "body" or "body.part[2]"
  PieceReader(const PieceDraft& piece, std::string table, Findings& findings, const SceneFolder& folder)
      : piece_(piece),
        table_(table),
        findings_(findings),
        shape_(piece.shape, std::move(table), findings, folder) {}

  std::optional<Piece> piece();
  /// Returns the shape in its place, without mass; for a table that has no keys for a mass.
  std::optional<Part> massless();

  std::string lengthPath() const { return shape_.lengthPath(); }

 private:
  std::string path(std::string_view name) const { return table_ + "." + std::string(name); }
  bool has(std::string_view name) const { return findings_.has(path(name)); }
  bool massFits();
  std::optional<double> mass(double volume_m3);
  std::optional<Piece> withMass(Part part);
  std::optional<physics::Quaternion> rotation();
  std::optional<physics::Quaternion> turnAboutAxis();

  const PieceDraft& piece_;
  std::string table_;
  Findings& findings_;
  ShapeReader shape_;
};

std::optional<Piece> pointMass(const PointDraft& point, const std::string& table, Findings& findings);

}  // namespace poinsot::scene
