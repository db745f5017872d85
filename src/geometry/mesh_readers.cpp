// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::geometry {
namespace {

constexpr std::string_view kSpaces = " \t\r\v\f";

core::SourceLocation locationOf(const std::string& name, const FilePlace& place) { return {name, place.line, 0}; }

std::string withByte(const FilePlace& place, const std::string& message) {
  return place.line > 0 ? message : fmt::format("byte {}: {}", place.byte, message);
}

/// from_chars knows no plus sign; "+-1" is still no number.
std::string_view withoutPlus(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  return word;
}

}  // namespace

void MeshBuilder::refuse(const FilePlace& place, const std::string& message) const {
  throw core::Error(core::ErrorKind::kScene, withByte(place, message), locationOf(name_, place));
}

void MeshBuilder::refuseAmount(const FilePlace& place, const std::string& message) const {
  throw core::Error(core::ErrorKind::kLimit, withByte(place, message), locationOf(name_, place));
}

void MeshBuilder::expectTriangles(std::uint64_t count, const FilePlace& place) const {
  if (count > limits_.triangles)
    refuseAmount(place,
                 fmt::format("the mesh has more than {} triangles, the most that are read", limits_.triangles));
}

void MeshBuilder::expectVertices(std::uint64_t count, const FilePlace& place) const {
  if (count > limits_.vertices())
    refuseAmount(place,
                 fmt::format("the mesh has more than {} vertices, the most that are read", limits_.vertices()));
}

void MeshBuilder::addVertex(const Eigen::Vector3d& v, const FilePlace& place) {
  if (!v.allFinite())
    refuse(place, fmt::format("coordinates of a vertex must be finite, got ({}, {}, {})", v[0], v[1], v[2]));
  expectVertices(vertexCount() + 1, place);
  mesh_.vertices_M.push_back(v);
}

void MeshBuilder::addFace(std::span<const std::int64_t> corners, const FilePlace& place) {
  if (corners.size() < 3) refuse(place, fmt::format("a face has three corners or more, got {}", corners.size()));
  for (const std::int64_t corner : corners)
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertexCount())
      refuse(place,
             fmt::format("a corner of a face is vertex {} (counted from 0) of {} so far", corner, vertexCount()));
  expectTriangles(mesh_.triangles.size() + corners.size() - 2, place);
  const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
  for (std::size_t i = 2; i < corners.size(); ++i) mesh_.triangles.push_back({at(0), at(i - 1), at(i)});
}

Mesh MeshBuilder::finished() const {
  if (mesh_.triangles.empty())
    throw core::Error(core::ErrorKind::kScene, "the file has no faces", core::SourceLocation{name_});
  return welded(mesh_);
}

bool LineReader::next() {
  if (rest_.empty()) return false;
  const std::size_t length = rest_.find('\n');
  line_ = rest_.substr(0, length);
  rest_.remove_prefix(length == rest_.npos ? rest_.size() : length + 1);
  ++number_;
  return true;
}

std::string_view takeWord(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kSpaces));
  line.remove_prefix(word.size());
  return word;
}

double toNumber(std::string_view given, const FilePlace& place, const MeshBuilder& builder) {
  const std::string_view word = withoutPlus(given);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range)
    builder.refuse(place, fmt::format("{} is beyond the numbers that a double holds", core::printable(given)));
  if (given.empty() || error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
    builder.refuse(place, fmt::format("expected a number, got \"{}\"", core::printable(given)));
  return value;
}

std::int64_t toWhole(std::string_view given, const FilePlace& place, const MeshBuilder& builder) {
  const std::string_view word = withoutPlus(given);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (given.empty() || error != std::errc() || end != word.data() + word.size())
    builder.refuse(place, fmt::format("expected a whole number, got \"{}\"", core::printable(given)));
  return value;
}

}  // namespace poinsot::geometry
