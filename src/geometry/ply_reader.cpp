// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "core/text.h"
#include "geometry/byte_order.h"
#include "geometry/mesh_file.h"
#include "geometry/ply_header.h"

namespace poinsot::geometry {
namespace {

constexpr const char* kEnd = "the file ends before the last row that its header declares; export the mesh again";

/// Reader of the numbers in the body of a PLY file, row by row.
class Values {
 public:
  virtual ~Values() = default;
  virtual void beginRow() {}
  /// Skips the rest of the row. Adds a note if the row has surplus numbers.
  virtual void endRow() {}
  /// Adds a note if data are left after the last row.
  virtual void finish() = 0;
  virtual double next(PlyScalar type) = 0;
  virtual std::int64_t nextWhole(PlyScalar type) = 0;
  virtual FilePlace place() const = 0;  ///< position of the last number that was read
};

bool isBlank(std::string_view line) { return takeWord(line).empty(); }

/// Returns whether the text has exactly one line for each row, as is usual. In other files, rows continue on the
/// next line, or one line contains several rows.
bool isByLines(LineReader lines, const PlyHeader& header) {
  std::uint64_t rows = 0, filled = 0;
  for (const PlyElement& element : header.elements) rows += element.count;
  while (lines.next()) filled += isBlank(lines.line()) ? 0 : 1;
  return filled == rows;
}

class AsciiValues : public Values {
 public:
  AsciiValues(const LineReader& lines, bool byLines, MeshBuilder& builder)
      : lines_(lines), byLines_(byLines), builder_(builder) {}

  double next(PlyScalar type) override {
    if (isWhole(type)) return static_cast<double>(nextWhole(type));
    const std::string_view word = nextWord();
    return toNumber(word, place(), builder_);
  }
  std::int64_t nextWhole(PlyScalar) override {
    const std::string_view word = nextWord();
    return toWhole(word, place(), builder_);
  }
  void beginRow() override {
    if (byLines_) nextLine();
  }
  void endRow() override {
    if (!byLines_) return;
    if (!isBlank(line_))
      builder_.note(place(), "the line has more numbers than the header declares; the rest is ignored");
    line_ = {};
  }
  void finish() override {
    while (isBlank(line_)) {
      if (!lines_.next()) return;
      line_ = lines_.line();
    }
    builder_.note(place(), "the text after the last row that the header declares is ignored");
  }
  FilePlace place() const override { return lines_.place(); }

 private:
  void nextLine() {
    do {
      if (!lines_.next()) builder_.refuse(place(), kEnd);
      line_ = lines_.line();
    } while (isBlank(line_));
  }

  std::string_view nextWord() {
    if (isBlank(line_) && byLines_)
      builder_.refuse(place(),
                      "the line has fewer numbers than the header declares; add them, or export the mesh again");
    if (isBlank(line_)) nextLine();
    return takeWord(line_);
  }

  LineReader lines_;
  std::string_view line_;
  bool byLines_;
  MeshBuilder& builder_;
};

class BinaryValues : public Values {
 public:
  BinaryValues(std::string_view bytes, std::size_t begin, std::endian order, MeshBuilder& builder)
      : bytes_(bytes), at_(begin), order_(order), builder_(builder) {}

  double next(PlyScalar type) override {
    switch (type) {
      case PlyScalar::kInt8:
        return take<std::int8_t>();
      case PlyScalar::kUint8:
        return take<std::uint8_t>();
      case PlyScalar::kInt16:
        return take<std::int16_t>();
      case PlyScalar::kUint16:
        return take<std::uint16_t>();
      case PlyScalar::kInt32:
        return take<std::int32_t>();
      case PlyScalar::kUint32:
        return take<std::uint32_t>();
      case PlyScalar::kFloat32:
        return static_cast<double>(take<float>());
      case PlyScalar::kFloat64:
        break;
    }
    return take<double>();
  }
  /// Returns an exact value: integers of a PLY file have at most 32 bits, which a double represents exactly.
  std::int64_t nextWhole(PlyScalar type) override { return static_cast<std::int64_t>(next(type)); }
  void finish() override {
    if (at_ < bytes_.size())
      builder_.note(atByte(at_), fmt::format("{} bytes after the last row that the header declares are ignored",
                                             bytes_.size() - at_));
  }
  FilePlace place() const override { return atByte(last_); }

 private:
  template <typename T>
  T take() {
    last_ = at_;
    if (bytes_.size() - at_ < sizeof(T)) builder_.refuse(place(), kEnd);
    const T value = fromBytes<T>(bytes_.substr(at_), order_);
    at_ += sizeof(T);
    return value;
  }

  std::string_view bytes_;
  std::size_t at_, last_ = 0;
  std::endian order_;
  MeshBuilder& builder_;
};

class BodyReader {
 public:
  BodyReader(Values& values, MeshBuilder& builder) : values_(values), builder_(builder) {}

  void read(const PlyElement& element) {
    if (element.name == "vertex") return readVertices(element);
    if (element.name == "face") return readFaces(element);
    readRows(element, [&] {
      for (const PlyProperty& property : element.properties) skip(property);
    });
  }

 private:
  template <typename ReadRow>
  void readRows(const PlyElement& element, const ReadRow& readRow) {
    for (std::uint64_t row = 0; row < element.count; ++row) {
      values_.beginRow();
      readRow();
      values_.endRow();
    }
  }

  void readVertices(const PlyElement& element) {
    builder_.expectVertices(element.count, element.place);
    std::vector<int> axes;  // axis of each property, 0 to 2; -1 if the property is ignored
    for (const PlyProperty& p : element.properties)
      axes.push_back(p.countType ? -1 : p.name == "x" ? 0 : p.name == "y" ? 1 : p.name == "z" ? 2 : -1);
    for (int axis = 0; axis < 3; ++axis)
      if (std::ranges::count(axes, axis) != 1)
        builder_.refuse(element.place,
                        fmt::format("element vertex must have one number {}; export the mesh again", "xyz"[axis]));
    readRows(element, [&] { readVertex(element, axes); });
  }

  void readVertex(const PlyElement& element, const std::vector<int>& axes) {
    Eigen::Vector3d v;
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (axes[i] < 0)
        skip(element.properties[i]);
      else
        v[axes[i]] = values_.next(element.properties[i].type);
    builder_.addVertex(v, values_.place());
  }

  void readFaces(const PlyElement& element) {
    builder_.expectTriangles(element.count, element.place);
    const auto isCorners = [](const PlyProperty& p) {
      return p.countType && isWhole(p.type) && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    if (std::ranges::count_if(element.properties, isCorners) != 1)
      builder_.refuse(element.place,
                      "element face must have one list vertex_indices of a whole type; export the mesh again");
    readRows(element, [&] {
      for (const PlyProperty& property : element.properties)
        if (isCorners(property))
          readFace(property);
        else
          skip(property);
    });
  }

  void readFace(const PlyProperty& property) {
    const std::uint64_t count = countOf(property);
    const FilePlace place = values_.place();
    builder_.expectTriangles(count, place);  // rejects a huge count before its corners are stored
    std::vector<std::int64_t> corners;
    for (std::uint64_t i = 0; i < count; ++i) corners.push_back(values_.nextWhole(property.type));
    builder_.addFace(corners, place);
  }

  void skip(const PlyProperty& property) {
    const std::uint64_t count = property.countType ? countOf(property) : 1;
    for (std::uint64_t i = 0; i < count; ++i) values_.next(property.type);
  }

  std::uint64_t countOf(const PlyProperty& list) {
    const std::int64_t count = values_.nextWhole(*list.countType);
    if (count < 0)
      builder_.refuse(values_.place(),
                      fmt::format("a list must have at least 0 numbers, got {}; export the mesh again", count));
    return static_cast<std::uint64_t>(count);
  }

  Values& values_;
  MeshBuilder& builder_;
};

std::unique_ptr<Values> valuesOf(const PlyHeader& header, const LineReader& lines, std::string_view bytes,
                                 MeshBuilder& builder) {
  if (header.encoding == PlyEncoding::kAscii)
    return std::make_unique<AsciiValues>(lines, isByLines(lines, header), builder);
  const std::endian order = header.encoding == PlyEncoding::kLittleEndian ? std::endian::little : std::endian::big;
  return std::make_unique<BinaryValues>(bytes, bytes.size() - lines.rest().size(), order, builder);
}

}  // namespace

void readPly(std::string_view bytes, MeshBuilder& builder) {
  LineReader lines(bytes);
  const PlyHeader header = readPlyHeader(lines, builder);
  const std::unique_ptr<Values> values = valuesOf(header, lines, bytes, builder);
  BodyReader body(*values, builder);
  for (const PlyElement& element : header.elements) body.read(element);
  values->finish();
}

}  // namespace poinsot::geometry
