// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/mesh_file.h"

namespace poinsot::geometry {

/// Builder of a mesh from the vertices and faces of a file. Checks the data, and reports errors with their
/// position in the file.
class MeshBuilder {
 public:
  MeshBuilder(std::string name, const MeshLimits& limits) : name_(std::move(name)), limits_(limits) {}

  std::size_t vertexCount() const { return mesh_.vertices_M.size(); }

  /// Adds a vertex.
  /// @throws core::Error at `place` if a coordinate is not finite, or if the mesh has too many vertices.
  void addVertex(const Eigen::Vector3d& v, const FilePlace& place);

  /// Adds a polygon as a fan of triangles from its first corner.
  /// @throws core::Error at `place` for fewer than three corners, for a corner whose vertex was not added before,
  /// or if the mesh has too many triangles.
  void addFace(std::span<const std::int64_t> corners, const FilePlace& place);

  /// Rejects a number of triangles beyond the limit; expectVertices() does the same for vertices. Readers check
  /// declared counts in this way before they read any data.
  void expectTriangles(std::uint64_t count, const FilePlace& place) const;
  void expectVertices(std::uint64_t count, const FilePlace& place) const;

  /// Adds a note that data at `place` are ignored. Notes with the same text become one note, with the first
  /// position and the number of positions.
  void note(const FilePlace& place, const std::string& text);

  /// Returns the mesh and leaves the builder empty. The mesh is welded. Its corners are joined if that closes the
  /// surface.
  /// @throws core::Error if the mesh has no triangle.
  MeshReading finished();

  [[noreturn]] void refuse(const FilePlace& place, const std::string& message) const;

 private:
  struct Note {
    FilePlace first;
    std::string text;
    std::size_t count = 0;
  };

  [[noreturn]] void refuseAmount(const FilePlace& place, const std::string& message) const;
  std::vector<std::string> noteTexts() const;
  void close(MeshReading& reading) const;

  std::string name_;
  MeshLimits limits_;
  Mesh mesh_;
  std::vector<Note> notes_;
};

void readObj(std::string_view text, MeshBuilder& builder);
void readStl(std::string_view bytes, MeshBuilder& builder);
void readPly(std::string_view bytes, MeshBuilder& builder);

/// Reader of the lines of a text. A line ends at \n; a \r before the \n counts as white space. A UTF-8 byte-order
/// mark at the start is skipped.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  bool next();
  std::string_view line() const { return line_; }
  FilePlace place() const { return atLine(number_); }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_, line_;
  std::uint64_t number_ = 0;
};

/// Removes the first word from a line and returns the word, or an empty text if the line has no word.
std::string_view takeWord(std::string_view& line);

/// Parses a word as a finite number. @throws core::Error at `place` if it is not one.
double toNumber(std::string_view word, const FilePlace& place, const MeshBuilder& builder);
/// Parses a word as a whole number. @throws core::Error at `place` if it is not one.
std::int64_t toWhole(std::string_view word, const FilePlace& place, const MeshBuilder& builder);

}  // namespace poinsot::geometry
