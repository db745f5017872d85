// SPDX-License-Identifier: Apache-2.0
#include "geometry/ply_header.h"

#include <fmt/format.h>

#include <utility>

#include "core/text.h"

namespace poinsot::geometry {
namespace {

constexpr std::pair<std::string_view, PlyScalar> kScalars[] = {
    {"char", PlyScalar::kInt8},      {"int8", PlyScalar::kInt8},       {"uchar", PlyScalar::kUint8},
    {"uint8", PlyScalar::kUint8},    {"short", PlyScalar::kInt16},     {"int16", PlyScalar::kInt16},
    {"ushort", PlyScalar::kUint16},  {"uint16", PlyScalar::kUint16},   {"int", PlyScalar::kInt32},
    {"int32", PlyScalar::kInt32},    {"uint", PlyScalar::kUint32},     {"uint32", PlyScalar::kUint32},
    {"float", PlyScalar::kFloat32},  {"float32", PlyScalar::kFloat32}, {"double", PlyScalar::kFloat64},
    {"float64", PlyScalar::kFloat64}};

constexpr std::pair<std::string_view, PlyEncoding> kEncodings[] = {
    {"ascii", PlyEncoding::kAscii},
    {"binary_little_endian", PlyEncoding::kLittleEndian},
    {"binary_big_endian", PlyEncoding::kBigEndian}};

template <typename Value, std::size_t N>
std::string namesIn(const std::pair<std::string_view, Value> (&table)[N]) {
  std::string names;
  for (const auto& [name, value] : table) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

class HeaderReader {
 public:
  HeaderReader(LineReader& lines, const MeshBuilder& builder) : lines_(lines), builder_(builder) {}

  PlyHeader read() {
    if (nextKey() != "ply")
      refuse(
          "a PLY file begins with a line \"ply\"; if this is another format, rename the file with its extension");
    if (nextKey() != "format")
      refuse(
          "the second line of a PLY file is its format, such as \"format ascii 1.0\"; add it, or export the mesh "
          "again");
    header_.encoding = found(kEncodings, takeWord(line_), "a PLY format");
    for (std::string_view key = nextKey(); key != "end_header"; key = nextKey()) readLine(key);
    for (const PlyElement& element : header_.elements)
      if (element.properties.empty())
        builder_.refuse(element.place,
                        fmt::format("element {} has no property; remove it, or export the mesh again",
                                    core::printable(element.name)));
    return std::move(header_);
  }

 private:
  std::string_view nextKey() {
    if (!lines_.next()) refuse("the file ends within the PLY header; export the mesh again");
    line_ = lines_.line();
    return takeWord(line_);
  }

  void readLine(std::string_view key) {
    if (key == "element")
      readElement();
    else if (key == "property")
      readProperty();
    else if (key != "comment" && key != "obj_info" && !key.empty())
      refuse(fmt::format(
          "expected element, property, comment or end_header, got \"{}\"; remove the line, or export the "
          "mesh again",
          core::printable(key)));
  }

  void readElement() {
    PlyElement element;
    element.name = takeWord(line_);
    const std::int64_t count = toWhole(takeWord(line_), lines_.place(), builder_);
    if (count < 0)
      refuse(fmt::format("an element must have at least 0 rows, got {}; export the mesh again", count));
    element.count = static_cast<std::uint64_t>(count);
    element.place = lines_.place();
    header_.elements.push_back(std::move(element));
  }

  void readProperty() {
    if (header_.elements.empty()) refuse("a property comes before the first element; export the mesh again");
    PlyProperty property;
    std::string_view type = takeWord(line_);
    if (type == "list") {
      property.countType = found(kScalars, takeWord(line_), "a PLY type");
      if (!isWhole(*property.countType))
        refuse("the count of a list must be of a whole type, such as uchar; export the mesh again");
      type = takeWord(line_);
    }
    property.type = found(kScalars, type, "a PLY type");
    property.name = takeWord(line_);
    header_.elements.back().properties.push_back(std::move(property));
  }

  template <typename Value, std::size_t N>
  Value found(const std::pair<std::string_view, Value> (&table)[N], std::string_view word,
              const char* what) const {
    for (const auto& [name, value] : table)
      if (name == word) return value;
    refuse(fmt::format("\"{}\" is not {}; it is one of {}", core::printable(word), what, namesIn(table)));
  }

  [[noreturn]] void refuse(const std::string& message) const { builder_.refuse(lines_.place(), message); }

  LineReader& lines_;
  const MeshBuilder& builder_;
  std::string_view line_;
  PlyHeader header_;
};

}  // namespace

PlyHeader readPlyHeader(LineReader& lines, const MeshBuilder& builder) {
  return HeaderReader(lines, builder).read();
}

}  // namespace poinsot::geometry
