// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "core/text.h"
#include "geometry/byte_order.h"
#include "geometry/mesh_readers.h"

namespace poinsot::geometry {
namespace {

// Layout of a binary STL: 80 bytes of any content, then the number of triangles. Each triangle takes 50 bytes: a
// normal and three corners as floats, and two bytes of any content.
constexpr std::size_t kHeaderBytes = 84, kCountAt = 80, kTriangleBytes = 50, kNormalBytes = 12;

// Number of bytes in which the first word is searched for. Blank lines may come before the first word.
constexpr std::size_t kLongestStart = 4096;

void addTriangle(MeshBuilder& builder, const FilePlace& place) {
  const auto count = static_cast<std::int64_t>(builder.vertexCount());
  builder.addFace(std::array{count - 3, count - 2, count - 1}, place);
}

Eigen::Vector3d vertexAt(std::string_view bytes, std::size_t at) {
  Eigen::Vector3d v;
  for (std::size_t axis = 0; axis < 3; ++axis)
    v[static_cast<int>(axis)] =
        static_cast<double>(fromBytes<float>(bytes.substr(at + 4 * axis), std::endian::little));
  return v;
}

void readBinary(std::string_view bytes, std::uint32_t count, MeshBuilder& builder) {
  builder.expectTriangles(count, atByte(kCountAt));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = kHeaderBytes + kTriangleBytes * i;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t at = begin + kNormalBytes * (corner + 1);
      builder.addVertex(vertexAt(bytes, at), atByte(at));
    }
    addTriangle(builder, atByte(begin));
  }
  const std::size_t end = kHeaderBytes + kTriangleBytes * std::size_t{count};
  if (bytes.size() > end)
    builder.note(atByte(end),
                 fmt::format("{} bytes after the last of {} triangles are ignored", bytes.size() - end, count));
}

/// Reader of an ASCII STL, line by line. Accepts keywords in capitals, and "end facet" for "endfacet".
class Ascii {
 public:
  explicit Ascii(MeshBuilder& builder) : builder_(builder) {}

  void read(std::string_view line, const FilePlace& place) {
    const std::string_view given = takeWord(line);
    std::string word = core::lowered(given);
    if (word == "end") word += core::lowered(takeWord(line));
    if (word == "vertex")
      readVertex(line, place);
    else if (word == "outer")
      corners_ = 0;
    else if (word == "endloop")
      finishLoop(place);
    else if (word == "solid" || word == "endsolid")
      ended_ = word == "endsolid";
    else if (word != "facet" && word != "endfacet" && !word.empty())
      refuseWord(given, place);
  }

  void finish(const FilePlace& place) const {
    if (!ended_)
      builder_.refuse(place,
                      "the file ends before endsolid, so that triangles may be missing; export the mesh again");
  }

 private:
  [[noreturn]] void refuseWord(std::string_view word, const FilePlace& place) const {
    builder_.refuse(place, fmt::format("expected facet, outer loop, vertex, endloop, endfacet or endsolid, got "
                                       "\"{}\"; remove the line, or export the mesh again",
                                       core::printable(word)));
  }

  void readVertex(std::string_view line, const FilePlace& place) {
    Eigen::Vector3d v;
    for (double& coordinate : v) coordinate = toNumber(takeWord(line), place, builder_);
    if (!takeWord(line).empty())
      builder_.note(place, "the text after the three coordinates of a vertex is ignored");
    builder_.addVertex(v, place);
    ++corners_;
  }

  void finishLoop(const FilePlace& place) {
    if (corners_ != 3)
      builder_.refuse(place,
                      fmt::format("a loop has three vertices, got {}; divide polygons into triangles", corners_));
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

std::string_view firstWord(std::string_view text) {
  LineReader lines(text);
  while (lines.next()) {
    std::string_view line = lines.line();
    if (const std::string_view word = takeWord(line); !word.empty()) return word;
  }
  return "";
}

/// Returns whether a file is ASCII. Many binary files begin with "solid", too, but their count of triangles
/// contains a zero byte.
bool isAscii(std::string_view bytes) {
  return core::lowered(firstWord(bytes.substr(0, kLongestStart))) == "solid" &&
         bytes.substr(0, kHeaderBytes).find('\0') == bytes.npos;
}

[[noreturn]] void refuseUnknown(std::string_view bytes, std::uint32_t count, std::uint64_t length,
                                const MeshBuilder& builder) {
  constexpr const char* kAscii = "an ASCII STL begins with \"solid\", but this file begins with";
  const std::string start = core::printable(firstWord(bytes.substr(0, kHeaderBytes)).substr(0, 20));
  if (bytes.size() < kHeaderBytes)
    builder.refuse(
        atByte(bytes.size()),
        fmt::format("the file ends within the {} bytes of a binary STL header; {} \"{}\"; export the mesh again",
                    kHeaderBytes, kAscii, start));
  builder.refuse(
      atByte(kCountAt),
      fmt::format("the file is truncated or is not an STL: a binary STL has its count of triangles here, and {} "
                  "triangles take {} bytes, but the file has {}; {} \"{}\"; export the mesh again",
                  count, length, bytes.size(), kAscii, start));
}

}  // namespace

// If the file has exactly the length that its triangle count requires, it is binary. The first word is checked
// later, because a binary file may begin with "solid", too.
void readStl(std::string_view bytes, MeshBuilder& builder) {
  const bool hasHeader = bytes.size() >= kHeaderBytes;
  const auto count = hasHeader ? fromBytes<std::uint32_t>(bytes.substr(kCountAt), std::endian::little) : 0;
  const std::uint64_t length = kHeaderBytes + kTriangleBytes * std::uint64_t{count};
  if (hasHeader && bytes.size() == length) return readBinary(bytes, count, builder);
  if (isAscii(bytes)) return readAscii(bytes, builder);
  if (!hasHeader || bytes.size() < length) refuseUnknown(bytes, count, length, builder);
  readBinary(bytes, count, builder);
}

}  // namespace poinsot::geometry
