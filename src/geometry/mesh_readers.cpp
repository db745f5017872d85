// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.h"
#include "core/text.h"
#include "geometry/mesh_joining.h"

namespace poinsot::geometry {
namespace {

constexpr std::string_view kSpaces = " \t\r\v\f";

core::SourceLocation locationOf(const std::string& name, const FilePlace& place) {
  return {name, place.isLine ? static_cast<int>(place.number) : 0, 0};
}

std::string withByte(const FilePlace& place, const std::string& message) {
  return place.isLine ? message : toString(place) + ": " + message;
}

/// Removes a leading plus sign, because std::from_chars() rejects it. "+-1" stays invalid.
std::string_view withoutPlus(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  return word;
}

[[noreturn]] void refuseWord(std::string_view word, const char* expected, const FilePlace& place,
                             const MeshBuilder& builder) {
  if (word.empty())
    builder.refuse(place,
                   fmt::format("expected {}, but the line ends; add it, or export the mesh again", expected));
  builder.refuse(place, fmt::format("expected {}, got \"{}\"; correct it, or export the mesh again", expected,
                                    core::printable(word)));
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
    refuseAmount(place, fmt::format("the mesh has more than the allowed {} triangles", limits_.triangles));
}

void MeshBuilder::expectVertices(std::uint64_t count, const FilePlace& place) const {
  if (count > limits_.vertices())
    refuseAmount(place, fmt::format("the mesh has more than the allowed {} vertices", limits_.vertices()));
}

void MeshBuilder::addVertex(const Eigen::Vector3d& v, const FilePlace& place) {
  if (!v.allFinite())
    refuse(place, fmt::format("coordinates of a vertex must be finite, got ({}, {}, {}); export the mesh again",
                              v[0], v[1], v[2]));
  expectVertices(vertexCount() + 1, place);
  mesh_.vertices_M.push_back(v);
}

void MeshBuilder::addFace(std::span<const std::int64_t> corners, const FilePlace& place) {
  if (corners.size() < 3)
    refuse(place, fmt::format("a face has three corners or more, got {}; remove the face", corners.size()));
  for (const std::int64_t corner : corners)
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertexCount())
      refuse(place, fmt::format("a corner of a face refers to vertex {} (counted from 0), but there are only {} "
                                "so far; refer to one of these, and put vertices before faces",
                                corner, vertexCount()));
  expectTriangles(mesh_.triangles.size() + corners.size() - 2, place);
  const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh_.triangles.push_back({at(0), at(i - 1), at(i)});
    mesh_.places.push_back(place);
  }
}

void MeshBuilder::note(const FilePlace& place, const std::string& text) {
  const auto same = std::ranges::find(notes_, text, &Note::text);
  if (same == notes_.end())
    notes_.push_back({place, text, 1});
  else
    ++same->count;
}

std::vector<std::string> MeshBuilder::noteTexts() const {
  std::vector<std::string> texts;
  for (const Note& note : notes_)
    texts.push_back(fmt::format("{}: {}{}", core::toString(locationOf(name_, note.first)),
                                withByte(note.first, note.text),
                                note.count > 1 ? fmt::format(" ({} places)", note.count) : ""));
  return texts;
}

void MeshBuilder::close(MeshReading& reading) const {
  std::optional<JoinedMesh> closed = closedByJoining(reading.mesh);
  if (!closed) return;
  reading.mesh = std::move(closed->mesh);
  reading.notes.push_back(fmt::format(
      "{}: {} corner{} joined to others, moved by at most {:.2g} in the file's unit ({:.2g} of the mesh's size), "
      "to close the surface; the file has them at different places by rounding",
      name_, closed->corners, closed->corners == 1 ? " was" : "s were", closed->farthest,
      closed->farthest / closed->size));
}

MeshReading MeshBuilder::finished() {
  if (mesh_.triangles.empty())
    throw core::Error(core::ErrorKind::kScene,
                      "the file has no faces; export the surface of the body, not points or lines alone",
                      core::SourceLocation{name_});
  MeshReading reading{welded(mesh_), noteTexts()};
  mesh_ = {};
  close(reading);
  return reading;
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
    builder.refuse(place, fmt::format("{} is beyond the range of a double; give lengths in a larger unit",
                                      core::printable(given)));
  if (given.empty() || error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
    refuseWord(given, "a number", place, builder);
  return value;
}

std::int64_t toWhole(std::string_view given, const FilePlace& place, const MeshBuilder& builder) {
  const std::string_view word = withoutPlus(given);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (given.empty() || error != std::errc() || end != word.data() + word.size())
    refuseWord(given, "a whole number", place, builder);
  return value;
}

}  // namespace poinsot::geometry
