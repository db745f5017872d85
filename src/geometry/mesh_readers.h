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

// The readers behind parseMesh(). Internal to this layer.
namespace poinsot::geometry {

/// Takes what a reader finds, checks it, and says where it is wrong.
class MeshBuilder {
 public:
  MeshBuilder(std::string name, const MeshLimits& limits) : name_(std::move(name)), limits_(limits) {}

  std::size_t vertexCount() const { return mesh_.vertices_M.size(); }

  /// @throws core::Error at `place` unless finite; beyond the limit.
  void addVertex(const Eigen::Vector3d& v, const FilePlace& place);

  /// A polygon, as the fan from its first corner. @throws core::Error at `place` for fewer than three corners or
  /// one that is no vertex so far; beyond the limit.
  void addFace(std::span<const std::int64_t> corners, const FilePlace& place);

  /// Refuses a count that a header claims, before anything is read by it.
  void expectTriangles(std::uint64_t count, const FilePlace& place) const;
  void expectVertices(std::uint64_t count, const FilePlace& place) const;

  /// Notes what is passed over at `place`. Notes with the same text become one, at the first place, with their
  /// number.
  void note(const FilePlace& place, const std::string& text);

  /// Gives the mesh away: welded, and with corners joined where that closes it.
  /// @throws core::Error if it has no triangle.
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

/// Lines of a text and the words of each. A line ends at \n; \r before it is white space. A byte-order mark of
/// UTF-8 at the start is passed over.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  /// Goes to the next line; false at the end.
  bool next();
  std::string_view line() const { return line_; }
  FilePlace place() const { return atLine(number_); }
  std::string_view rest() const { return rest_; }  ///< what follows the line

 private:
  std::string_view rest_, line_;
  std::uint64_t number_ = 0;
};

/// Cuts the first word off a line; empty if there is none.
std::string_view takeWord(std::string_view& line);

/// The number that a word is, finite. @throws core::Error at `place`.
double toNumber(std::string_view word, const FilePlace& place, const MeshBuilder& builder);
/// Likewise, whole.
std::int64_t toWhole(std::string_view word, const FilePlace& place, const MeshBuilder& builder);

}  // namespace poinsot::geometry
