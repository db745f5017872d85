// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/shape_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/text.h"
#include "scene/keys/foreign_words.h"
#include "scene/keys/unknown_key.h"
#include "scene/keys/value_forms.h"
#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

const NamedShape* shapeNamed(std::string_view word) {
  const auto found = std::ranges::find(namedShapes(), word, &NamedShape::word);
  return found == namedShapes().end() ? nullptr : &*found;
}

const Node* valueIn(const Leaves& leaves, const std::string& path) {
  const auto found = leaves.values.find(path);
  return found == leaves.values.end() ? nullptr : &found->second;
}

/// Returns the value of a key in the scene, or else in an example of a message, as TOML; empty if there is none.
std::string textIn(const Leaves& leaves, const std::string& path) {
  if (const Node* given = valueIn(leaves, path)) return given->as<DateOrTime>() ? "" : tomlText(*given);
  const auto example = leaves.examples.find(path);
  return example == leaves.examples.end() ? "" : example->second;
}

std::string unquoted(std::string_view text) {
  const bool quoted = text.size() > 1 && text.starts_with('"') && text.ends_with('"');
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

bool isGiven(const Leaves& leaves, const std::string& path) {
  return leaves.values.contains(path) || leaves.meant.contains(path);
}

/// Returns the lines for keys that a shape needs and the scene lacks, of the set of keys that lacks the fewest.
std::string missingLines(const NamedShape& shape, const std::string& table, const Leaves& leaves) {
  std::string best;
  std::size_t fewest = 100;
  for (const KeyNames& way : shape.ways) {
    std::string lines;
    std::size_t missing = 0;
    for (const std::string_view name : way) {
      const std::string path = pathBelow(table, name);
      if (isGiven(leaves, path)) continue;
      ++missing;
      lines += fmt::format("\n    {} = {}", name, name == "size" ? sizeExample(shape) : findKey(path)->example);
    }
    if (missing >= fewest) continue;
    fewest = missing;
    best = std::move(lines);
  }
  return best;
}

/// Returns the three extents of a shape that takes only its size, from the sides that a table gives; empty if the
/// table gives fewer than two.
std::vector<std::string_view> givenSides(const NamedShape& shape, const std::string& table, const Leaves& leaves) {
  std::vector<std::string_view> sides;
  if (shape.ways.size() != 1 || shape.ways[0] != KeyNames{"size"} || shape.extents != 3) return sides;
  if (isGiven(leaves, pathBelow(table, "size"))) return sides;
  for (const std::string_view name : {"length", "width", "height"})
    if (leaves.values.contains(pathBelow(table, name))) sides.push_back(name);
  if (sides.size() < 2) sides.clear();
  return sides;
}

/// Returns the shape and its size for the sides of a table. The last of two sides counts twice, as in an egg.
std::string sizeAdvice(const NamedShape& shape, const std::vector<std::string_view>& sides,
                       const std::string& table, const Leaves& leaves) {
  std::string size;
  for (std::size_t i = 0; i < 3; ++i) {
    const Node* side = valueIn(leaves, pathBelow(table, sides[std::min(i, sides.size() - 1)]));
    size += (size.empty() ? "[" : ", ") + tomlText(*side);
  }
  return fmt::format("; did you mean \"{0}\"? For example, in place of {1}:\n    shape = \"{0}\"\n    size = {2}]",
                     shape.word, listed({sides.begin(), sides.end()}), size);
}

bool isAnyOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

std::string dumbbell(const Leaves& leaves) {
  const Node* mass = valueIn(leaves, "body.mass");
  const std::string half = mass ? tomlText(scaled(*mass, 0.5)) : "1";
  std::string text = mass ? ", in place of shape and mass" : ", in place of shape";
  text = "; a dumbbell is made of two parts. For example, at the end of the file" + text + ":";
  for (const char* offset : {"[-0.25, 0, 0]", "[0.25, 0, 0]"})
    text += fmt::format(
        "\n    [[body.part]]\n    shape = \"sphere\"\n    radius = 0.1\n    mass = {}\n    offset = {}", half,
        offset);
  return text;
}

}  // namespace

std::string_view sizeExample(const NamedShape& shape) {
  if (shape.extents == 2) return "[0.3, 0.2]";
  if (shape.word == "cylinder") return "[0.1, 0.1, 0.3]";
  return shape.word == "racket" ? "[0.68, 0.26, 0.02]" : findKey("body.size")->example;
}

std::string nearestShape(std::string_view given) {
  if (given.size() > kLongestName) return "";
  const std::string word = plainWord(given);
  const std::vector<std::string_view> words = shapeWords();
  if (shapeNamed(word)) return word;
  if (const auto other = wordElsewhere(word); shapeNamed(other)) return std::string(other);
  if (const auto near = core::closest(word, {words.begin(), words.end()})) return *near;
  std::vector<std::string> pieces;
  for (std::size_t begin = 0; begin <= word.size();) {
    const std::size_t end = std::min(word.find('_', begin), word.size());
    pieces.push_back(word.substr(begin, end - begin));
    begin = end + 1;
  }
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {  // the last word is the noun
    if (piece->size() < 3) continue;
    if (shapeNamed(*piece)) return *piece;
    if (const auto other = wordElsewhere(*piece); shapeNamed(other)) return std::string(other);
  }
  return "";
}

bool isRound(std::string_view shape) {
  return isAnyOf(shape, {"cylinder", "cylinder_shell", "disc", "hoop", "cone", "cone_shell", "torus",
                         "torus_shell", "capsule", "hemisphere", "sphere", "sphere_shell"});
}

std::string shapeAdvice(const std::string& path, const Node& given, const Leaves& leaves) {
  const auto* text = given.as<std::string>();
  const std::string table(tableOf(path)), word = text && text->size() <= kLongestName ? plainWord(*text) : "";
  const bool hasMoments = isGiven(leaves, "body.principal_moments") || isGiven(leaves, "body.inertia");
  if (table == "body" && hasMoments)
    return "; leave it out: the scene gives the moments, and a shape would set them too (show.body.shape only "
           "draws "
           "one)";
  if (table == "body" && isAnyOf(word, {"dumbbell", "dumb_bell", "barbell", "dumbell", "two_balls", "dipole"}))
    return leaves.meant.contains("body.part[].mass") || leaves.meant.contains("body.point_mass[].mass")
               ? "; leave it out: the masses and their positions make the body"
               : dumbbell(leaves);
  std::string shape = nearestShape(word);
  std::string note;
  if (shape.empty()) note = "; build a body of several solids of [[body.part]] tables, or take the nearest solid";
  if (shape.empty()) shape = "box";
  const bool isThick = isGiven(leaves, pathBelow(table, "height")) || isGiven(leaves, pathBelow(table, "length"));
  if (shape == "disc" && isThick) shape = "cylinder";
  if (shape == "hoop" && isGiven(leaves, pathBelow(table, "inner_radius"))) shape = "cylinder";
  if (shape == "hoop" && isThick) shape = "cylinder_shell";
  if (shape == "rod") shape = "cylinder";  // a rod alone has no moment about its line
  if (text && shape == *text) return "";
  if (const auto sides = givenSides(*shapeNamed(shape), table, leaves); !sides.empty())
    return note + sizeAdvice(*shapeNamed(shape), sides, table, leaves);
  return fmt::format("{}; did you mean \"{}\"? For example:\n    shape = \"{}\"{}", note, shape, shape,
                     missingLines(*shapeNamed(shape), table, leaves));
}

std::vector<double> momentsIn(const Leaves& leaves) {
  const auto numbers = [&](const char* path) {
    return numbersInToml(textIn(leaves, path), findKey(path)->dimension);
  };
  if (const auto moments = numbers("body.principal_moments"); moments.size() == 3) return moments;
  const auto tensor = numbers("body.inertia");
  for (std::size_t i = 0; i < tensor.size(); ++i)
    if (tensor.size() != 9 || (i % 4 != 0 && tensor[i] != 0)) return {};  // not a diagonal tensor
  return tensor.empty() ? tensor : std::vector<double>{tensor[0], tensor[4], tensor[8]};
}

bool isUnderGravity(const Leaves& leaves) {
  const auto isGravity = [](std::string_view path) { return path.starts_with("motion.gravity."); };
  const auto given = leaves.values.lower_bound("motion.gravity.");
  const auto meant = leaves.meant.lower_bound("motion.gravity.");
  return (given != leaves.values.end() && isGravity(given->first)) ||
         (meant != leaves.meant.end() && isGravity(*meant));
}

std::string spinAxisText(const Leaves& leaves) {
  if (isRound(nearestShape(unquoted(textIn(leaves, "body.shape"))))) return "\"3\"";
  if (const auto moments = momentsIn(leaves); moments.size() == 3)
    for (std::size_t axis : {2, 0, 1})
      if (moments[(axis + 1) % 3] == moments[(axis + 2) % 3]) return fmt::format("\"{}\"", axis + 1);
  return isUnderGravity(leaves) ? "\"3\"" : "\"largest\"";
}

std::string pivotText(const Leaves& leaves) {
  if (isGiven(leaves, "body.centre_of_mass")) return "[0, 0, 0]";  // its distance from the origin is given
  const std::string shape(unquoted(textIn(leaves, "body.shape")));
  std::string height = textIn(leaves, "body.height");
  if (const std::string size = textIn(leaves, "body.size"); std::ranges::count(size, ',') == 2)
    height = core::trimmed(size.substr(size.rfind(',') + 1, size.rfind(']') - size.rfind(',') - 1));
  if (numbersInToml(height, Dimension::kLength).size() != 1) return "[0, 0, \"-5 cm\"]";
  // A cone stands on its tip, three quarters of its height away.
  const double factor = shape.starts_with("cone") ? -0.75 : -0.5;
  if (height.starts_with('"')) return fmt::format("[0, 0, {}]", tomlText(scaled({unquoted(height), {}}, factor)));
  return fmt::format("[0, 0, {:.6g}]", factor * numbersInToml(height, Dimension::kLength)[0]);
}

}  // namespace poinsot::scene
