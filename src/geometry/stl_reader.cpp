// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/text.h"
#include "geometry/byte_order.h"
#include "geometry/mesh_readers.h"

namespace poinsot::geometry {
namespace {

// Binary: 80 bytes of anything, the number of triangles, then 50 bytes each: a normal and three corners as floats,
// and two bytes of anything.
constexpr std::size_t kHeaderBytes = 84, kCountAt = 80, kTriangleBytes = 50, kNormalBytes = 12;

void addTriangle(MeshBuilder& builder, const FilePlace& place) {
  const auto count = static_cast<std::int64_t>(builder.vertexCount());
  builder.addFace(std::array{count - 3, count - 2, count - 1}, place);
}

void readBinary(std::string_view bytes, std::uint32_t count, MeshBuilder& builder) {
  builder.expectTriangles(count, {0, kCountAt});
  for (std::size_t i = 0; i < count; ++i) {
    const FilePlace place{0, kHeaderBytes + kTriangleBytes * i};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t at = place.byte + kNormalBytes * (corner + 1);
      Eigen::Vector3d v;
      for (std::size_t axis = 0; axis < 3; ++axis)
        v[static_cast<int>(axis)] =
            static_cast<double>(fromBytes<float>(bytes.substr(at + 4 * axis), std::endian::little));
      builder.addVertex(v, {0, at});
    }
    addTriangle(builder, place);
  }
}

/// The lines of an ASCII file, one after another.
class Ascii {
 public:
  explicit Ascii(MeshBuilder& builder) : builder_(builder) {}

  void read(std::string_view line, const FilePlace& place) {
    const std::string_view word = takeWord(line);
    if (word == "vertex")
      readVertex(line, place);
    else if (word == "outer")
      corners_ = 0;
    else if (word == "endloop")
      finishLoop(place);
    else if (word == "solid" || word == "endsolid")
      ended_ = word == "endsolid";
    else if (word != "facet" && word != "endfacet" && !word.empty())
      builder_.refuse(place,
                      fmt::format("expected facet, outer loop, vertex, endloop, endfacet or endsolid, got \"{}\"",
                                  core::printable(word)));
  }

  void finish(const FilePlace& place) const {
    if (!ended_) builder_.refuse(place, "the file ends before endsolid");
  }

 private:
  void readVertex(std::string_view line, const FilePlace& place) {
    Eigen::Vector3d v;
    for (double& coordinate : v) coordinate = toNumber(takeWord(line), place, builder_);
    builder_.addVertex(v, place);
    ++corners_;
  }

  void finishLoop(const FilePlace& place) {
    if (corners_ != 3) builder_.refuse(place, fmt::format("a loop has three vertices, got {}", corners_));
    addTriangle(builder_, place);
    corners_ = 0;
  }

  MeshBuilder& builder_;
  std::size_t corners_ = 0;
  bool ended_ = false;
};

void readAscii(std::string_view text, MeshBuilder& builder) {
  LineReader lines(text);
  Ascii ascii(builder);
  while (lines.next()) ascii.read(lines.line(), lines.place());
  ascii.finish(lines.place());
}

}  // namespace

// Many binary files begin with "solid" too: a length that fits the count decides.
void readStl(std::string_view bytes, MeshBuilder& builder) {
  const bool hasHeader = bytes.size() >= kHeaderBytes;
  const auto count = hasHeader ? fromBytes<std::uint32_t>(bytes.substr(kCountAt), std::endian::little) : 0;
  const std::uint64_t length = kHeaderBytes + kTriangleBytes * std::uint64_t{count};
  if (hasHeader && bytes.size() == length) return readBinary(bytes, count, builder);
  std::string_view start = bytes.substr(0, bytes.find('\n'));
  if (takeWord(start) == "solid") return readAscii(bytes, builder);
  if (!hasHeader) builder.refuse({0, bytes.size()}, "the file ends within the header of a binary STL");
  builder.refuse({0, kCountAt},
                 fmt::format("{} triangles make a binary STL of {} bytes, got {}", count, length, bytes.size()));
}

}  // namespace poinsot::geometry
