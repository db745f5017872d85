// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <vector>

#include "geometry/mesh_readers.h"

namespace poinsot::geometry {
namespace {

/// Returns the vertex index, from 0, of a face's corner, which is written "v", "v/vt", "v//vn" or "v/vt/vn". A
/// negative v counts back from the last vertex.
std::int64_t cornerOf(std::string_view word, const FilePlace& place, const MeshBuilder& builder) {
  const std::int64_t number = toWhole(word.substr(0, word.find('/')), place, builder);
  const auto count = static_cast<std::int64_t>(builder.vertexCount());
  if (number == 0 || number > count || number < -count)
    builder.refuse(place, fmt::format("a corner of a face refers to vertex {}, but there are only {} so far; "
                                      "count from 1, or back from the last with -1, and put vertices before faces",
                                      number, count));
  return number > 0 ? number - 1 : count + number;
}

void readVertex(std::string_view rest, const FilePlace& place, MeshBuilder& builder) {
  Eigen::Vector3d v;
  for (double& coordinate : v) coordinate = toNumber(takeWord(rest), place, builder);
  builder.addVertex(v, place);  // a weight or a colour after the position is ignored
}

void readFace(std::string_view rest, const FilePlace& place, MeshBuilder& builder) {
  std::vector<std::int64_t> corners;
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
    corners.push_back(cornerOf(word, place, builder));
    builder.expectTriangles(corners.size() < 3 ? 0 : corners.size() - 2,
                            place);  // stops an endless face before it fills the memory
  }
  builder.addFace(corners, place);
}

/// Returns the current line without its comment. If a line ends with a backslash, the next line is appended.
std::string wholeLine(LineReader& lines) {
  std::string whole(lines.line());
  const auto continues = [&] {
    if (whole.ends_with('\r')) whole.pop_back();
    return whole.ends_with('\\');
  };
  while (continues() && lines.next()) {
    whole.back() = ' ';
    whole += lines.line();
  }
  return whole.substr(0, whole.find('#'));
}

}  // namespace

void readObj(std::string_view text, MeshBuilder& builder) {
  LineReader lines(text);
  while (lines.next()) {
    const std::string whole = wholeLine(lines);
    std::string_view rest = whole;
    const std::string_view key = takeWord(rest);
    if (key == "v") readVertex(rest, lines.place(), builder);
    if (key == "f") readFace(rest, lines.place(), builder);
  }
}

}  // namespace poinsot::geometry
