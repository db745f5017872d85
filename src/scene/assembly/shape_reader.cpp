// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/shape_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "physics/mass_properties.h"
#include "scene/keys/shape_advice.h"

namespace poinsot::scene {
namespace {

bool holds(const KeyNames& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string extentsText(const std::vector<double>& size) {
  if (size.size() == 1) return fmt::format("({0}, {0}, {0})", size[0]);
  return fmt::format("({}, {}, {})", size[0], size[1], size.at(2));
}

/// Returns what is wrong with the extents in the key `size`; empty if they are valid. Such a message names `size`.
/// The errors of the physics library name lengths that are derived from it.
std::string extentsProblem(const NamedShape& kind, const std::vector<double>& size) {
  if (size.size() != 1 && size.size() != kind.extents)
    return fmt::format("shape \"{}\" has {} extents, got {}", kind.word, kind.extents, size.size());
  const double x = size[0], y = size.size() == 1 ? x : size[1];
  if (kind.word == "cylinder" && x != y)
    return fmt::format("the x and y extents of a cylinder must be equal, got {} m", extentsText(size));
  if (kind.word == "racket" && !(x > y))
    return fmt::format("a racket must be longer (x) than wide (y), got {} m", extentsText(size));
  return "";
}

}  // namespace

Part asPart(const Figure& figure) {
  Part part;
  std::visit([&](const auto& kind) { part.figure = kind; }, figure);
  return part;
}

bool extentsSuit(const NamedShape& kind, const std::vector<double>& size) {
  return extentsProblem(kind, size).empty();
}

bool ShapeReader::sized() const {
  const KeyNames& names = shapeKeyNames();
  return std::any_of(names.begin(), names.end(), [this](std::string_view name) { return has(name); });
}

bool ShapeReader::given() const { return has("shape") || sized(); }

std::string ShapeReader::lengthPath() const {
  for (const std::string_view name : shapeKeyNames())
    if (has(name)) return path(name);
  return path("shape");
}

/// Returns the set of keys, such as radius and height, of which the fewest are missing. If several sets are
/// equally near, returns the one of which the most are given.
const KeyNames& ShapeReader::nearestWay() const {
  const auto lacks = [this](const KeyNames& way) {
    const auto missing = static_cast<std::ptrdiff_t>(missingOf(way).size());
    return std::pair(missing,
                     missing - static_cast<std::ptrdiff_t>(way.size()));  // second, the most that are given
  };
  return *std::min_element(kind().ways.begin(), kind().ways.end(),
                           [&](const KeyNames& a, const KeyNames& b) { return lacks(a) < lacks(b); });
}

std::string ShapeReader::lineFor(std::string_view name) const {
  return fmt::format("\n    {} = {}", name, name == "size" ? sizeExample(kind()) : findKey(path(name))->example);
}

/// Returns advice for lengths that the shape does not take: the key that it takes instead, with their values.
std::string ShapeReader::adviceFor(const KeyNames& foreign, const KeyNames& missing) const {
  if (missing.size() != 1 || foreign.empty()) return "";
  std::string value;
  if (foreign.size() == 1 && missing[0] != "size") value = findings_.textOf(path(foreign[0]));
  if (missing[0] == "size" && foreign.size() == kind().extents)
    for (const std::string_view name : {"length", "width", "height"})
      if (holds(foreign, name)) value += (value.empty() ? "[" : ", ") + findings_.textOf(path(name));
  if (value.empty()) return "";
  if (missing[0] == "size") value += "]";
  return fmt::format(". For example, in place of {}:\n    {} = {}", listed(foreign), missing[0], value);
}

KeyNames ShapeReader::missingOf(const KeyNames& way) const {
  KeyNames missing;
  for (const std::string_view name : way)
    if (!has(name) && !findings_.misspelt(path(name))) missing.push_back(name);
  return missing;
}

/// Returns advice for a shape whose lengths are missing: lines with examples, or the body of the catalogue.
std::string ShapeReader::adviceForMissing(const KeyNames& missing) const {
  std::string text = ". For example:";
  for (const std::string_view name : missing) text += lineFor(name);
  if (!isInCatalogue() || sized()) return text;
  return text +
         fmt::format("\n  or, in place of shape and mass, the body of the catalogue:\n    catalogue = \"{}\"",
                     kind().word);
}

bool ShapeReader::isInCatalogue() const {
  const Key& catalogue = *findKey("body.catalogue");
  return path("shape") == "body.shape" &&
         std::find(catalogue.words.begin(), catalogue.words.end(), kind().word) != catalogue.words.end();
}

bool ShapeReader::refuseForeign(const KeyNames& way) {
  KeyNames names;
  for (const std::string_view name : shapeKeyNames())
    if (has(name) && !holds(way, name) && !holds(kind().optional, name)) names.push_back(name);
  const std::string advice = adviceFor(names, missingOf(way));
  hasAdvice_ = !advice.empty();
  bool foreign = false;
  for (const std::string_view name : shapeKeyNames()) {
    if (!has(name) || holds(way, name) || holds(kind().optional, name)) continue;
    foreign = true;
    findings_.refuse(path(name), fmt::format("is not allowed here: shape \"{}\" takes {}{}", kind().word,
                                             described(kind()), name == names[0] ? advice : ""));
  }
  return foreign;
}

bool ShapeReader::refuseMissing(const KeyNames& way) {
  KeyNames missing;
  for (const std::string_view name : way)
    if (!has(name)) missing.push_back(name);
  if (missing.empty()) return false;
  std::erase_if(missing, [this](std::string_view name) { return findings_.misspelt(path(name)); });
  if (missing.empty()) return true;
  findings_.refuse(path("shape"), fmt::format("\"{}\" takes {}; {} missing{}", kind().word, described(kind()),
                                              listed(missing) + (missing.size() == 1 ? " is" : " are"),
                                              adviceForMissing(missing)));
  return true;
}

bool ShapeReader::sizeFits() {
  if (!shape_.size) return true;
  const std::string problem = extentsProblem(kind(), *shape_.size);
  if (kind().word == "plate" && shape_.size->size() == 3) {
    findings_.refuse(path("shape"),
                     "\"plate\" has 2 extents, got 3; a plate with a thickness is a box. For example:\n"
                     "    shape = \"box\"");
    return false;
  }
  if (!problem.empty()) findings_.refuse(path("size"), problem);
  return problem.empty();
}

bool ShapeReader::keysFit() {
  const KeyNames& way = nearestWay();
  const bool foreign = refuseForeign(way);
  const bool missing = !hasAdvice_ ? refuseMissing(way) : !missingOf(way).empty();
  if (foreign || missing) return false;
  const auto passed = [this](std::string_view name) { return !findings_.failed(path(name)); };
  return std::all_of(way.begin(), way.end(), passed) &&
         std::all_of(kind().optional.begin(), kind().optional.end(), passed) && sizeFits();
}

/// Returns the path of the last length. Lengths that do not fit together are reported there, because the last
/// length (wall, tube or inner radius) must be smaller than the others.
std::string ShapeReader::lastPath() const {
  std::string last = path("shape");
  for (const KeyNames* names : {&nearestWay(), &kind().optional})
    for (const std::string_view name : *names)
      if (has(name)) last = path(name);
  return last;
}

std::optional<Figure> ShapeReader::solid() {
  physics::Solid solid = kind().make(shape_);
  try {
    physics::massProperties(solid, 1);
  } catch (const core::Error& error) {
    findings_.refuse(lastPath(), error.message());
    return std::nullopt;
  }
  return Figure(std::move(solid));
}

std::optional<Figure> ShapeReader::mesh() {
  try {
    geometry::MeshReading reading = folder_.readMesh(*shape_.file);
    for (const std::string& note : reading.notes) findings_.doubt(path("file"), note);
    return Figure(std::make_shared<const geometry::Mesh>(geometry::transformed(
        std::move(reading.mesh), shape_.fileUnit_m.value_or(1) * Eigen::Matrix3d::Identity())));
  } catch (const core::Error& error) {
    findings_.refuse(path("file"),
                     error.what());  // what() contains the file and the line of the mistake in the mesh
    return std::nullopt;
  }
}

std::optional<Figure> ShapeReader::figure() {
  if (!has("shape")) {
    findings_.refuseMissing(
        path("shape"), lengthPath(),
        fmt::format("{} is missing; this key describes a shape. For example:\n    shape = "
                    "\"{}\"",
                    path("shape"), has("radius") ? has("height") ? "cylinder" : "sphere" : "box"));
    return std::nullopt;
  }
  if (!shape_.word || !keysFit()) return std::nullopt;
  return kind().make ? solid() : mesh();
}

}  // namespace poinsot::scene
