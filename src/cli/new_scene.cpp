// SPDX-License-Identifier: Apache-2.0
#include "cli/new_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <regex>
#include <vector>

#include "core/expect.h"
#include "core/text.h"
#include "request/scene_request.h"
#include "scene/catalogue_mass.h"
#include "scene/document/problem.h"

// Embedded content of the file new_scene.toml.
extern "C" const char poinsot_new_scene[], poinsot_new_scene_end[];

namespace poinsot::cli {
namespace {

constexpr double kHeaviestInHand_kg = 100;  // heavier bodies of the catalogue turn in hours or days

using Lines = std::vector<std::string>;

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '-';
}

/// Returns a title for a scene's name, such as "My book" for "my_book". A name with special characters gives a
/// default title, because a title may contain TeX.
std::string titleOf(std::string name) {
  std::ranges::replace(name, '_', ' ');
  if (name.empty() || !std::ranges::all_of(name, isPlain)) return "A new scene";
  if (name.front() >= 'a' && name.front() <= 'z') name.front() = static_cast<char>(name.front() - 'a' + 'A');
  return name;
}

void replaceAll(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

/// Returns a quantity of the template as a TOML value. If the user prefers another unit, converts and rounds the
/// value to three digits.
std::string inUnit(const std::string& quantity, scene::Dimension dimension, const request::UnitChoice& units) {
  const bool bare = quantity.find(' ') == quantity.npos;
  const auto choice = units.find(dimension);
  if (choice == units.end()) return bare ? quantity : '"' + quantity + '"';
  const std::string_view si = scene::siUnit(dimension);
  const double value = scene::parseQuantity(bare ? fmt::format("{} {}", quantity, si) : quantity, dimension).value;
  const double converted = value / scene::unitFactor(choice->second, dimension);
  const double rounded = std::strtod(fmt::format("{:.3g}", converted).c_str(), nullptr);  // 1200, not 1.2e+03
  return fmt::format("\"{} {}\"", rounded, choice->second);
}

/// Replaces marks in the template, such as "@length:24 cm@", with quantities in the user's units.
void setQuantities(std::string& text, const request::UnitChoice& units) {
  for (const scene::Dimension dimension : scene::dimensions()) {
    const std::string mark = "@" + request::dimensionWord(dimension) + ":";
    for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at)) {
      const std::size_t begin = at + mark.size(), end = text.find('@', begin);
      text.replace(at, end + 1 - at, inUnit(text.substr(begin, end - begin), dimension, units));
    }
  }
}

void replaceTable(std::string& text, std::string_view table, std::string_view with) {
  const std::size_t begin = text.find(fmt::format("[{}]", table)), end = text.find("\n\n", begin);
  POINSOT_EXPECT(begin != text.npos && end != text.npos);
  text.replace(begin, end - begin, with);
}

/// Lets the template begin with a body of the catalogue that spins about its middle axis, and so flips.
void useCatalogue(std::string& text, std::string_view name) {
  replaceTable(text, "body",
               fmt::format("[body]  # a real body; poinsot explain body.catalogue lists all\n"
                           "catalogue = \"{}\"\n"
                           "# instead of this key: a solid and its mass, which set the moments of inertia\n"
                           "# shape = \"box\"\n"
                           "# size = [@length:24 cm@, @length:17 cm@, @length:3 cm@]\n"
                           "# mass = @mass:1.2 kg@",
                           name));
  replaceTable(text, "motion",
               "[motion]  # the start\n"
               "spin = @angular_velocity:0.5 rev/s@\n"
               "spin_axis = \"middle\"  # the body flips; about \"smallest\" or \"largest\" it does not\n"
               "tilt = @angle:2 deg@  # of the angular momentum from this axis\n"
               "# instead of these keys: omega about the body's x, y and z, or omega in space\n"
               "# omega_body = [@angular_velocity:0.04@, @angular_velocity:3.2@, @angular_velocity:0.04@]\n"
               "# omega_space = [0, 0, @angular_velocity:3.2@]");
}

Lines linesOf(std::string_view text) {
  Lines lines;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    lines.emplace_back(text.substr(begin, end - begin));
  }
  return lines;
}

/// Aligns the comments of the template. Quantities in the user's units may have changed the length of lines.
void alignComments(std::string& text) {
  constexpr std::size_t kColumn = 38;
  Lines lines = linesOf(text);
  for (std::string& line : lines)
    if (const std::size_t comment = line.rfind("  # "); comment != line.npos) {
      const std::string code = line.substr(0, line.find_last_not_of(' ', comment) + 1);
      line = fmt::format("{:<{}}{}", code, std::max(code.size() + 2, kColumn), line.substr(comment + 2));
    }
  text = fmt::format("{}\n", core::joined(lines, "\n"));
}

/// Returns "show.body" for the line "[show.body]", with or without a comment. Returns nullopt for other lines.
std::optional<std::string> headerOf(const std::string& line) {
  if (!line.starts_with('[') || line.starts_with("[[")) return std::nullopt;
  return line.substr(1, line.find(']') - 1);
}

/// Returns the index of the line that opens the deepest table for the key, or the number of lines if no table
/// fits.
std::size_t tableLine(const Lines& lines, const std::string& path) {
  std::size_t deepest = lines.size(), depth = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (const auto header = headerOf(lines[i]);
        header && path.starts_with(*header + ".") && header->size() > depth) {
      deepest = i;
      depth = header->size();
    }
  return deepest;
}

bool names(std::string_view line, const std::string& name, bool offers) {
  if (offers && line.starts_with("# ")) line.remove_prefix(2);
  return line.starts_with(name + " =") || line.starts_with(name + "=");
}

bool hasKey(std::string_view text, const std::string& path) {
  const Lines lines = linesOf(text);
  const std::size_t header = tableLine(lines, path);
  if (header == lines.size()) return false;
  const std::string name = path.substr(headerOf(lines[header])->size() + 1);
  for (std::size_t i = header + 1; i < lines.size() && !lines[i].starts_with('['); ++i)
    if (names(lines[i], name, false)) return true;
  return false;
}

bool isGood(const std::string& text) {
  try {
    request::loadRequested({"scene.toml", text, {}, std::nullopt, {}});
    return true;
  } catch (const scene::SceneErrors&) {
    return false;
  }
}

}  // namespace

std::string withKey(std::string_view text, const request::DefaultKey& key) {
  Lines lines = linesOf(text);
  const std::size_t header = tableLine(lines, key.path);
  if (header == lines.size()) {
    const std::size_t dot = key.path.find('.');
    lines.insert(lines.end(), {"", fmt::format("[{}]", key.path.substr(0, dot)),
                               fmt::format("{} = {}", key.path.substr(dot + 1), key.value)});
    return fmt::format("{}\n", core::joined(lines, "\n"));
  }
  const std::string name = key.path.substr(headerOf(lines[header])->size() + 1);
  const std::string line = fmt::format("{} = {}", name, key.value);
  std::size_t i = header + 1;
  while (i < lines.size() && !lines[i].starts_with('[') && !names(lines[i], name, true)) ++i;
  if (i < lines.size() && names(lines[i], name, true))
    lines[i] = line;
  else
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(header) + 1, line);
  return fmt::format("{}\n", core::joined(lines, "\n"));
}

std::string blankScene(const std::string& name, const request::UserDefaults& defaults) {
  std::string text(poinsot_new_scene, poinsot_new_scene_end);
  if (scene::catalogueMass_kg(name).value_or(kHeaviestInHand_kg) < kHeaviestInHand_kg) useCatalogue(text, name);
  setQuantities(text, defaults.units);
  alignComments(text);
  for (const request::DefaultKey& key : defaults.keys) text = withKey(text, key);
  replaceAll(text, "@NAME@", core::printable(name));
  replaceAll(text, "@TITLE@", titleOf(name));
  return text;
}

std::string galleryScene(std::string text, const request::UserDefaults& defaults) {
  for (const request::DefaultKey& key : defaults.keys) {
    if (hasKey(text, key.path)) continue;
    if (std::string with = withKey(text, key); isGood(with)) text = std::move(with);
  }
  return text;
}

}  // namespace poinsot::cli
