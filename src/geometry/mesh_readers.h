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

/// Builder of a mesh from the data that a reader finds. Checks the data, and reports errors with their place.
class MeshBuilder {
 public:
  MeshBuilder(std::string name, const MeshLimits& limits) : name_(std::move(name)), limits_(limits) {}

  std::size_t vertexCount() const { return mesh_.vertices_M.size(); }

  /// @throws core::Error at `place` if a coordinate is not finite, or beyond the limit.
  void addVertex(const Eigen::Vector3d& v, const FilePlace& place);

  /// Adds a polygon as a fan of triangles from its first corner. @throws core::Error at `place` for fewer than
  /// three corners, for a corner that is no vertex so far, or beyond the limit.
  void addFace(std::span<const std::int64_t> corners, const FilePlace& place);

  /// Rejects a count in a header that is beyond the limit, before any data are read by it.
  void expectTriangles(std::uint64_t count, const FilePlace& place) const;
  void expectVertices(std::uint64_t count, const FilePlace& place) const;

  /// Notes data that are ignored at `place`. Notes with the same text become one, with the first place and count.
  void note(const FilePlace& place, const std::string& text);

  /// Returns the mesh and leaves the builder empty. The mesh is welded, and corners are joined if that closes it.
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

/// Reader of the lines of a text. A line ends at \n, and \r before it is white space. A UTF-8 byte-order mark at
/// the start is skipped.
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

/// Removes the first word from a line and returns the word; empty if there is none.
std::string_view takeWord(std::string_view& line);

/// Returns the finite number that a word spells. @throws core::Error at `place` otherwise.
double toNumber(std::string_view word, const FilePlace& place, const MeshBuilder& builder);
/// Returns the whole number that a word spells. @throws core::Error at `place` otherwise.
std::int64_t toWhole(std::string_view word, const FilePlace& place, const MeshBuilder& builder);

}  // namespace poinsot::geometry
