// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/unknown_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "core/text.h"
#include "scene/keys/carried_value.h"
#include "scene/keys/foreign_names.h"
#include "scene/keys/foreign_words.h"
#include "scene/keys/key_text.h"
#include "scene/keys/shape_advice.h"
#include "scene/keys/similar_keys.h"
#include "scene/keys/tensor_text.h"
#include "scene/keys/unknown_key.h"
#include "scene/keys/value_forms.h"
#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

// Number of names for which an example is made. A report shows no more problems than this.
constexpr std::size_t kMostExamples = 50;

/// Key for which unknown names of one table stand, with lines to paste.
struct Counterpart {
  std::vector<std::string> names;  ///< names, without their table
  std::string key;                 ///< path of the key; empty if nothing stands for the names
  std::vector<KeyLine> lines;      ///< the key and its value, and other keys with their values
  std::string with;                ///< other keys that the key needs, as in ForeignNames::with
  std::string note{};
  std::vector<std::string> replaced{};  ///< names of known keys that the lines replace
  std::string instead{};                ///< other text for what the lines replace
  std::vector<std::pair<const Key*, std::string>>
      choices{};            ///< keys with their values, one of which may be meant
  std::string otherwise{};  ///< another meaning of the value, and its line, which follow the example
};

/// Returns other keys that a shape needs: "radius = "10 cm"; mass = 1" for "sphere".
std::string needsOf(std::string_view shape) {
  std::string with;
  for (const NamedShape& known : namedShapes())
    if (known.word == shape)
      for (const std::string_view name : known.ways.back())  // the way without a size, if there is one
        with += fmt::format("{} = {}; ", name,
                            name == "size" ? sizeExample(known) : findKey(pathBelow("body", name))->example);
  return with + "mass = 1";
}

std::string needsOf(const std::string& key, const std::string& value, std::string_view with) {
  if (nameOf(key) != "shape" || value.size() < 2) return std::string(with);
  return needsOf(std::string_view(value).substr(1, value.size() - 2));
}

std::vector<KeyLine> parsedLines(std::string_view with) {
  std::vector<KeyLine> lines;
  while (!with.empty()) {
    const std::size_t end = std::min(with.find(';'), with.size()), equals = with.find('=');
    lines.push_back({std::string(core::trimmed(with.substr(0, equals))),
                     std::string(core::trimmed(with.substr(equals + 1, end - equals - 1)))});
    with.remove_prefix(std::min(end + 1, with.size()));
  }
  return lines;
}

/// Returns the value that an example shows if the given value does not fit: the example of the key.
std::vector<KeyLine> exampleOf(const Key& key) {
  const std::string_view value = key.example.empty() ? key.fallback : key.example;
  if (value.empty()) return {};
  return {{std::string(nameOf(key.path)), std::string(value)}};
}

std::string numberText(double number) { return fmt::format("{:.6g}", number); }

/// Returns whether a name is that of the film's length and not of the motion's.
bool isOfFilm(std::string_view name) {
  const std::string small = core::lowered(name);
  return std::ranges::any_of(
      std::to_array<std::string_view>({"film", "video", "movie", "clip", "animation", "screen", "playback"}),
      [&](std::string_view word) { return small.find(word) != std::string::npos; });
}

class Report {
 public:
  Report(std::vector<UnknownName> names, Leaves& leaves, Problems& problems)
      : names_(std::move(names)), leaves_(leaves), problems_(problems) {
    std::ranges::stable_sort(names_, {},
                             [](const UnknownName& name) { return std::tie(name.place.line, name.place.column); });
    for (const UnknownName& name : names_) values_.emplace(name.path, name.value);
  }

  void run() {
    std::vector<std::pair<const UnknownName*, std::optional<Counterpart>>> found;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (taken_.contains(names_[i].path)) continue;
      auto counterpart = i < kMostExamples ? counterpartOf(names_[i]) : std::nullopt;
      if (counterpart && isOnOneLine(names_[i]))
        counterpart->replaced.emplace_back(nameOf(tableOf(names_[i].path)));
      if (counterpart) take(*counterpart, tableOf(names_[i].path));
      found.emplace_back(&names_[i], std::move(counterpart));
    }
    for (const auto& [name, counterpart] : found)
      if (counterpart || name->isTable)
        problems_.add(name->place, messageOf(*name, counterpart));
      else
        problems_.addLater(name->place, [path = name->path, at = ours(name->path),
                                         elsewhere = !leadsToOtherSubject(ours(name->path))] {
          const std::string message = unknownKey(at, elsewhere);
          return at == path ? message
                            : core::printable(path) + message.substr(std::min(message.find(':'), message.size()));
        });
  }

  /// Returns advice for a value that does not suit its key.
  std::string adviceFor(const std::string& path, const Node& value) {
    values_[path] = &value;
    const auto counterpart = foreignCounterpart(path, path);
    if (!counterpart) return "";
    leaves_.meant.insert(counterpart->key);
    return advice(path, value.place, *counterpart);
  }

 private:
  /// Returns whether a name is in a table on one line, such as energy_dissipation = { tau = 200 }.
  bool isOnOneLine(const UnknownName& name) const {
    if (!leaves_.aliases.contains(tableOf(name.path)) || !name.place.source->hasLines()) return false;
    const std::string_view line = core::trimmed(name.place.source->line(name.place.line));
    return line.starts_with(nameOf(tableOf(name.path))) && line.find('{') != std::string_view::npos;
  }

  /// Marks the names of a counterpart as reported, and its keys as meant.
  void take(const Counterpart& counterpart, std::string_view table) {
    for (const std::string& name : counterpart.names) taken_.insert(pathBelow(table, name));
    if (counterpart.key.empty()) return;
    leaves_.meant.insert(counterpart.key);
    for (const auto& [key, value] : counterpart.choices) leaves_.meant.insert(key->path);
    for (const KeyLine& line : counterpart.lines) {
      const std::string path = pathBelow(line.table.empty() ? tableOf(counterpart.key) : line.table, line.name);
      leaves_.meant.insert(path);
      leaves_.examples.emplace(path, line.value);
    }
  }

  /// Returns the path that a name would have in this program: "motion.torque.Mx" for "torque.Mx".
  std::string ours(const std::string& path) const {
    const auto alias = leaves_.aliases.find(tableOf(path));
    return alias == leaves_.aliases.end() ? path : pathBelow(alias->second, nameOf(path));
  }

  std::optional<Counterpart> counterpartOf(const UnknownName& unknown) const {
    const std::string &path = unknown.path, at = ours(path);
    const std::string_view table = tableOf(path);
    if (nameOf(path).size() > kLongestName) return std::nullopt;
    if (unknown.isTable) return valueInPlaceOfTable(path);
    if (const std::string array = arrayNamed(path); !array.empty())
      if (auto elements = elementsOf(array, path)) return elements;
    const bool isForeign =
        table.find_first_of(".[") == std::string_view::npos && !isTableArray(table) && !misspelt("", table);
    if (!(isTable(table) || isForeign || at != path)) return std::nullopt;
    if (unknown.value->as<Node::Table>()) return rowThatTakes(path, at);
    if (auto unit = unitOfOther(path)) return unit;
    if (at != path)
      if (auto same = knownKey(at, path)) return same;
    if (auto sides = sidesCounterpart(path)) return sides;
    if (auto arrow = namedArrow(path)) return arrow;
    if (auto foreign = foreignCounterpart(path, at)) return foreign;
    if (table == "show" && unknown.value->as<Node::Array>())
      if (auto shown = shownCounterpart(path)) return shown;
    if (auto shape = shapeCounterpart(path)) return shape;
    if (auto unit = unitCounterpart(path, at)) return unit;
    if (auto near = misspeltCounterpart(path, *unknown.value)) return near;
    auto other = keyElsewhere(path, *unknown.value);
    if (other && !isOfOtherSubject(at, other->key)) return other;
    if (auto similar = similarCounterpart(path, at, *unknown.value)) return similar;
    const Key* key = other ? findKey(other->key) : nullptr;
    return key && carriedValue(*key, *unknown.value, leaves_.limits) ? other : std::nullopt;
  }

  /// Returns whether the only key with this name is of another subject.
  static bool leadsToOtherSubject(const std::string& path) {
    const auto other = nameOf(path).size() > kLongestName ? std::nullopt : otherKey(path);
    return other && findKey(*other) && isOfOtherSubject(path, *other);
  }

  /// Returns whether one path is of the physics and the other of the picture.
  static bool isOfOtherSubject(std::string_view path, std::string_view key) {
    const auto isPhysics = [](std::string_view one) {
      return one.starts_with("body") || one.starts_with("motion");
    };
    return path.find('.') != std::string_view::npos && isPhysics(path) != isPhysics(key);
  }

  /// Returns a key of our table for a name in a table of another name, such as motion.torque.body for torque.body.
  std::optional<Counterpart> knownKey(const std::string& at, const std::string& path) const {
    const Key* key = findKey(at);
    if (!key) return std::nullopt;
    const auto carried = carriedValue(*key, *values_.at(path), leaves_.limits);
    std::vector<KeyLine> lines = exampleOf(*key);
    if (carried) lines = {{std::string(nameOf(key->path)), *carried}};
    return Counterpart{{std::string(nameOf(path))}, at, std::move(lines), ""};
  }

  std::optional<Counterpart> foreignCounterpart(const std::string& path, const std::string& at) const {
    if (auto taken = rowThatTakes(path, at)) return taken;
    std::vector<const ForeignNames*> rows = plausibleRows(at);
    std::erase_if(rows, [&](const ForeignNames* row) { return !counts(*row, path) || isOfMeasured(*row); });
    if (rows.empty()) return std::nullopt;
    const auto example = std::ranges::find(rows, Carry::kNothing, &ForeignNames::carry);
    const ForeignNames& row = example == rows.end() ? *rows[0] : **example;
    return row.key.empty() ? std::nullopt : ofRow(row, path, at, exampleOf(*findKey(keyFor(row, at))));
  }

  /// Returns the first row of foreign names whose key takes the given values.
  std::optional<Counterpart> rowThatTakes(const std::string& path, const std::string& at) const {
    const bool isTable = values_.at(path)->as<Node::Table>() != nullptr;
    for (const ForeignNames* row : plausibleRows(at)) {
      if (isOfMeasured(*row)) continue;
      if (isTable && row->carry != Carry::kValue && row->carry != Carry::kEuler && row->carry != Carry::kReversed)
        continue;
      if (auto counterpart = takenBy(*row, path, at)) return counterpart;
    }
    return std::nullopt;
  }

  /// Returns whether a row leads to a height although the moments describe the body.
  bool isOfMeasured(const ForeignNames& row) const {
    return row.key == "body.height" && (mentions("body.principal_moments") || mentions("body.inertia"));
  }

  /// Returns whether a row applies, because its other name is there too if it needs one.
  bool counts(const ForeignNames& row, const std::string& path) const {
    return row.carry != Carry::kLaunch || presentNames(row, path).size() == 2;
  }

  std::optional<Counterpart> takenBy(const ForeignNames& row, const std::string& path,
                                     const std::string& at) const {
    switch (row.carry) {
      case Carry::kRemove:
        return removed(row, path);
      case Carry::kFilm:
        return filmCounterpart(path);
      case Carry::kShown:
        return shownCounterpart(path);
      case Carry::kPlot:
        return plotCounterpart(row, path);
      case Carry::kArrow:
        return arrowCounterpart(path);
      case Carry::kPoints:
        return pointsCounterpart(row, path);
      case Carry::kFrames:
        return framesCounterpart(row, path);
      case Carry::kEuler:
        if (auto other = otherSequence(row, path)) return other;
        break;
      default:
        break;
    }
    const std::string key = keyFor(row, at);
    if (key == "motion.drag.rate") return dragCounterpart(row, path, at);
    if (row.carry == Carry::kNothing && isInTable(row, at)) return ofRow(row, path, at, exampleOf(*findKey(key)));
    const bool isBody = key == "body.shape" || key == "body.catalogue";
    if (isBody && nameOf(path) == "name" && (tableOf(path) != "body" || hasBody()))
      return std::nullopt;  // a title
    if (auto directed = directedCounterpart(key, path)) return directed;
    if (row.factor == 2 && key.ends_with(".size") && row.carry != Carry::kValue && isBox(path)) {
      ForeignNames whole = row;
      whole.factor = 1;
      whole.note = {};
      return ofRow(whole, path, at, carriedLines(whole, *findKey(key), valuesOf(row, path), leaves_.limits));
    }
    if (key == "motion.tilt" && isTop()) {
      const ForeignNames lean{row.names, "motion.lean", row.with,
                              "It is the angle to the vertical under gravity."};
      return ofRow(lean, path, at, carriedLines(lean, *findKey(lean.key), valuesOf(lean, path), leaves_.limits));
    }
    if (row.note.starts_with("Each is a unit inertia")) return unitInertia(row, path, at);
    if (key == "motion.torque.body" || key == "motion.torque.space")
      if (auto torque = torqueOfTable(path)) return torque;
    if (key == "motion.gravity.g") return gravityCounterpart(row, path);
    if (key == "motion.precession" && row.carry == Carry::kNothing) return steadyCounterpart(row, path);
    if (key == "time.duration" && isOfFilm(nameOf(path)))
      if (auto film = filmCounterpart(path)) return film;
    const bool isMomentum = key == "motion.L_body" || key == "motion.L";
    if (isMomentum && !values_.at(path)->as<Node::Array>() && mentionsAttitude())
      return takenBy({row.names, "motion.L_space"}, path, at);  // a single number is along the vertical
    auto counterpart = withUnitBeside(row, path, at);
    if (!counterpart)
      counterpart = ofRow(row, path, at, carriedLines(row, *findKey(key), valuesOf(row, path), leaves_.limits));
    const bool isMeasured = mentions("body.principal_moments") || mentions("body.inertia");
    if (counterpart && row.carry == Carry::kBelow && isMeasured)
      counterpart->note += " The moments are about the centre of mass, unless moments_about = \"pivot\".";
    if (counterpart && key == "motion.orientation") addOtherOrder(*counterpart, row, path);
    return counterpart;
  }

  /// Returns whether the table of a name belongs to the name of a row, such as motion.dissipation.tau.
  static bool isInTable(const ForeignNames& row, const std::string& path) {
    const auto names = namesIn(row);
    return tableOf(path).find('.') != std::string_view::npos &&
           std::ranges::find(names, patternOf(path)) != names.end();
  }

  std::optional<Counterpart> ofRow(const ForeignNames& row, const std::string& path, const std::string& at,
                                   std::vector<KeyLine> lines) const {
    if (lines.empty()) return std::nullopt;
    const std::string key = keyFor(row, at);
    std::string with = needsOf(key, lines[0].value, row.with);
    Counterpart counterpart{presentNames(row, path), key, std::move(lines), std::move(with),
                            std::string(row.note)};
    if (key == "body.principal_moments") makePossible(counterpart);
    if (key == "body.inertia") sayIfImpossible(counterpart);
    return counterpart;
  }

  // ---- values that need others

  /// Puts the nearest possible moments in place of moments that no solid body can have.
  static void makePossible(Counterpart& counterpart) {
    std::string& value = counterpart.lines[0].value;
    const auto moments = numbersInToml(value, findKey(counterpart.key)->dimension);
    if (moments.size() != 3 || std::ranges::any_of(moments, [](double moment) { return !(moment > 0); })) return;
    const std::string nearest = nearestMomentsText(moments);
    if (nearest.empty()) return;
    if (!counterpart.note.empty()) counterpart.note += ' ';
    counterpart.note += triangleMessage(Eigen::Vector3d(moments[0], moments[1], moments[2])) +
                        ". These are the nearest possible ones.";
    value = nearest;
  }

  static void sayIfImpossible(Counterpart& counterpart) {
    const auto nine = numbersInToml(counterpart.lines[0].value, findKey(counterpart.key)->dimension);
    if (nine.size() != 9) return;
    const std::string why = whyImpossible(Eigen::Map<const Eigen::Matrix3d>(nine.data()));
    if (why.empty()) return;
    if (!counterpart.note.empty()) counterpart.note += ' ';
    counterpart.note += "It is impossible: " + why + ".";
  }

  /// Returns the torque of a single [[torque]] with a value and an axis.
  std::optional<Counterpart> torqueOfTable(const std::string& path) const {
    const auto* tables = values_.at(path)->as<Node::Array>();
    const auto* entries = tables && tables->size() == 1 ? (*tables)[0].as<Node::Table>() : nullptr;
    if (!entries) return std::nullopt;
    const auto entry = [&](std::initializer_list<std::string_view> names) -> const Node* {
      for (const Entry& one : *entries)
        if (std::ranges::find(names, one.key) != names.end()) return &one.value;
      return nullptr;
    };
    const Node* frame = entry({"frame", "axes"});
    const auto* word = frame ? frame->as<std::string>() : nullptr;
    const bool inSpace = word && word->size() <= kLongestName &&
                         (plainWord(*word) == "space" || wordElsewhere(plainWord(*word)) == "space");
    const Node *value = entry({"value", "magnitude", "torque", "size"}), *axis = entry({"axis", "direction"});
    const ForeignNames row{"", inSpace ? "motion.torque.space" : "motion.torque.body", "", "", Carry::kDirected};
    auto lines = carriedLines(row, *findKey(row.key), {value, axis}, leaves_.limits);
    if (lines.empty()) return std::nullopt;
    Counterpart counterpart{{std::string(nameOf(path))}, std::string(row.key), std::move(lines), ""};
    counterpart.instead = fmt::format("[[{}]]", core::printable(path));
    return counterpart;
  }

  std::optional<Counterpart> unitInertia(const ForeignNames& row, const std::string& path,
                                         const std::string& at) const {
    ForeignNames whole = row;
    const Node* mass = knownValue("body.mass");
    whole.factor = mass ? numberIn(*mass).value_or(1) : 1;
    return ofRow(whole, path, at, carriedLines(whole, *findKey(row.key), valuesOf(row, path), leaves_.limits));
  }

  /// Returns the rate of a drag. If the name is that of a coefficient and the moments are known, computes it.
  std::optional<Counterpart> dragCounterpart(const ForeignNames& row, const std::string& path,
                                             const std::string& at) const {
    const Key& key = *findKey(row.key);
    const auto* text = values_.at(path)->as<std::string>();
    const bool hasItsUnit =
        text && text->size() <= kLongestName && parseQuantity(*text, Dimension::kAngularMomentum).ok();
    const bool isCoefficient = row.carry == Carry::kNothing || hasItsUnit;
    const auto carried = carriedValue(key, *values_.at(path), leaves_.limits, row.unit);
    const std::string divided = dividedByMoments(*values_.at(path));
    if (isCoefficient && divided.empty()) return std::nullopt;  // the example of the key
    if (!isCoefficient && !carried) return std::nullopt;
    auto counterpart = ofRow(row, path, at, {{"rate", isCoefficient ? divided : *carried}});
    if (!isCoefficient && !divided.empty())
      counterpart->otherwise = fmt::format("\n  or, for a coefficient in N m s:\n    {} = {}",
                                           tableOf(path) == "motion" ? "drag.rate" : "rate", divided);
    return counterpart;
  }

  /// Returns a coefficient in N m s divided by each moment of the body, as TOML; empty if they are unknown.
  std::string dividedByMoments(const Node& coefficient) const {
    auto c = numberIn(coefficient);
    if (const auto* given = coefficient.as<std::string>(); given && given->size() <= kLongestName)
      if (const Quantity read = parseQuantity(*given, Dimension::kAngularMomentum); read.ok()) c = read.value;
    const auto moments = momentsIn(leaves_);
    if (!c || moments.size() != 3) return "";
    std::string text;
    for (const double moment : moments) {
      if (!(moment > 0) || !(*c >= 0) || !std::isfinite(*c / moment)) return "";
      text += fmt::format("{}{:.6g}", text.empty() ? "[" : ", ", *c / moment);
    }
    return text + "]";
  }

  /// Adds the line for a quaternion whose scalar is the last of its numbers, if it may be: a small rotation has a
  /// large scalar.
  void addOtherOrder(Counterpart& counterpart, const ForeignNames& row, const std::string& path) const {
    const auto* four = values_.at(path)->as<Node::Array>();
    if (row.carry != Carry::kValue || !four || four->size() != 4) return;
    const auto first = numberIn((*four)[0]), last = numberIn((*four)[3]);
    if (!first || !last || !(std::abs(*last) > std::abs(*first))) return;
    const Node turned = listNode({(*four)[3], (*four)[0], (*four)[1], (*four)[2]}, values_.at(path)->place);
    counterpart.note = "The order is w, x, y, z: no rotation is [1, 0, 0, 0].";
    counterpart.otherwise =
        fmt::format("\n  or, if no rotation is [0, 0, 0, 1] where this comes from:\n    {} = {}",
                    counterpart.lines[0].name, tomlText(turned));
  }

  /// Returns the value of a row with the unit that another name of the table gives: omega with omega_units.
  std::optional<Counterpart> withUnitBeside(const ForeignNames& row, const std::string& path,
                                            const std::string& at) const {
    if (row.carry != Carry::kValue || !row.unit.empty()) return std::nullopt;
    const Key& key = *findKey(keyFor(row, at));
    for (const std::string_view ending : {"_units", "_unit"}) {
      const std::string name = std::string(nameOf(path)) + std::string(ending);
      const Node* unit = valueOf(path, name);
      const auto* text = unit ? unit->as<std::string>() : nullptr;
      if (!text || text->size() > kLongestName || !parseQuantity("1 " + *text, key.dimension).ok()) continue;
      ForeignNames whole = row;
      whole.unit = *text;
      auto counterpart = ofRow(whole, path, at, carriedLines(whole, key, {values_.at(path)}, leaves_.limits));
      if (counterpart) counterpart->names.push_back(name);
      return counterpart;
    }
    return std::nullopt;
  }

  /// Returns the value with its unit for a name such as "omega_units", beside "omega".
  std::optional<Counterpart> unitOfOther(const std::string& path) const {
    const std::string_view name = nameOf(path);
    const auto* unit = values_.at(path)->as<std::string>();
    if (!unit || !(name.ends_with("_units") || name.ends_with("_unit") || name == "units" || name == "unit"))
      return std::nullopt;
    const std::string stem = pathBelow(tableOf(path), name.substr(0, std::min(name.rfind('_'), name.size())));
    if (valueOf(path, nameOf(stem)) && stem != path) {
      auto counterpart = foreignCounterpart(stem, ours(stem));
      const bool both = counterpart && std::ranges::find(counterpart->names, name) != counterpart->names.end();
      if (both) return counterpart;
    }
    Counterpart counterpart{{std::string(name)}, "", {}, "", "Each value has its unit: \"30 deg\"."};
    const Key* key = findKey(stem);
    const Node* value = key ? knownValue(stem) : nullptr;
    if (!value || unit->size() > kLongestName) return counterpart;
    const auto carried = carriedValue(*key, *value, leaves_.limits, *unit);
    if (!carried || !parseQuantity("1 " + *unit, key->dimension).ok()) return counterpart;
    return Counterpart{{std::string(name)},        stem, {{std::string(nameOf(stem)), *carried}}, "", "",
                       {std::string(nameOf(stem))}};
  }

  /// Returns the length of a film with a number of frames.
  std::optional<Counterpart> framesCounterpart(const ForeignNames& row, const std::string& path) const {
    auto frames = numberIn(*values_.at(path));
    Counterpart counterpart{{std::string(nameOf(path))}, std::string(row.key), {}, "", std::string(row.note)};
    for (const std::string_view name : {"frame_start", "start_frame", "first_frame"})
      if (const auto first = values_.find(pathBelow(tableOf(path), name)); first != values_.end()) {
        if (!taken_.contains(first->first)) counterpart.names.emplace_back(name);
        if (frames) *frames -= numberIn(*first->second).value_or(1) - 1;
      }
    if (!frames || !(*frames >= 1 && *frames < 1e9)) return std::nullopt;
    counterpart.lines.push_back({"duration", numberText(*frames / framesPerSecond())});
    return counterpart;
  }

  double framesPerSecond() const {
    const Node* given = knownValue("time.fps");
    for (const UnknownName& name : names_) {
      const auto rows = plausibleRows(ours(name.path));
      if (!rows.empty() && rows[0]->key == "time.fps" && rows[0]->carry == Carry::kValue) given = name.value;
    }
    const auto numbers =
        numbersInToml(given ? tomlTextOf(*given) : findKey("time.fps")->fallback, Dimension::kNone);
    return numbers.size() == 1 && numbers[0] > 0 ? numbers[0] : 60;
  }

  static std::string tomlTextOf(const Node& node) {
    const auto number = numberIn(node);
    return number ? fmt::format("{}", *number) : "";
  }

  static bool takesSeveral(const ForeignNames& row) {
    return row.carry == Carry::kList || row.carry == Carry::kTensor || row.carry == Carry::kNothing ||
           row.carry == Carry::kSymmetric || row.carry == Carry::kDirected || row.carry == Carry::kEither ||
           row.carry == Carry::kPoints || row.carry == Carry::kInches || row.carry == Carry::kLaunch;
  }

  std::vector<std::string> presentNames(const ForeignNames& row, const std::string& path) const {
    std::vector<std::string> names;
    if (takesSeveral(row))
      for (const std::string_view name : namesIn(row))
        if (valueOf(path, nameOf(name))) names.emplace_back(nameOf(name));
    if (names.empty()) names.emplace_back(nameOf(path));
    return names;
  }

  std::vector<const Node*> valuesOf(const ForeignNames& row, const std::string& path) const {
    std::vector<const Node*> values;
    if (!takesSeveral(row)) return {values_.at(path)};
    for (const std::string_view name : namesIn(row)) values.push_back(valueOf(path, nameOf(name)));
    return values;
  }

  /// Returns the value of another unknown name of the same table; null if there is none.
  const Node* valueOf(const std::string& path, std::string_view name) const {
    const std::string sibling = pathBelow(tableOf(path), name);
    const auto found = values_.find(sibling);
    return found == values_.end() || taken_.contains(sibling) ? nullptr : found->second;
  }

  /// Returns the value of a name of the same table, known or not; null if there is none.
  const Node* anyValueOf(const std::string& path, std::string_view name) const {
    if (const Node* value = valueOf(path, name)) return value;
    return knownValue(pathBelow(tableOf(path), name));
  }

  const Node* knownValue(const std::string& path) const {
    const auto found = leaves_.values.find(path);
    return found == leaves_.values.end() ? nullptr : &found->second;
  }

  /// Returns whether the scene gives a key that begins with `start`, or an unknown name leads to such a key.
  bool mentions(std::string_view start) const {
    const auto next = leaves_.values.lower_bound(start);
    if (next != leaves_.values.end() && next->first.starts_with(start)) return true;
    const auto meant = leaves_.meant.lower_bound(start);
    if (meant != leaves_.meant.end() && meant->starts_with(start)) return true;
    return std::ranges::any_of(names_, [&](const UnknownName& name) {
      if (taken_.contains(name.path)) return false;  // among those that are meant
      const auto rows = plausibleRows(ours(name.path));
      const auto row = std::ranges::find_if(rows, [&](const auto* one) { return counts(*one, name.path); });
      if (row != rows.end()) return (*row)->key.starts_with(start);
      const auto near = misspelt(tableOf(name.path), nameOf(name.path));
      return near && near->starts_with(start);
    });
  }

  /// Returns whether the scene has a top under gravity.
  bool isTop() const { return !isThrown() && mentions("motion.gravity."); }

  bool mentionsAttitude() const {
    return mentions("motion.euler.") || mentions("motion.orientation") || mentions("motion.roll_pitch_yaw");
  }

  bool isThrown() const {
    const auto next = leaves_.meant.lower_bound("motion.flight.");
    return mentions("motion.flight.") || (next != leaves_.meant.end() && next->starts_with("motion.flight."));
  }

  // ---- names for which nothing stands

  std::optional<Counterpart> removed(const ForeignNames& row, const std::string& path) const {
    if (path.starts_with("camera.") && row.note.starts_with("The camera always") && isThrown())
      return Counterpart{{std::string(nameOf(path))}, "camera.follow", {{"follow", "true"}}, ""};
    return Counterpart{{std::string(nameOf(path))}, "", {}, "", std::string(row.note)};
  }

  // ---- gravity

  /// Returns the key of gravity for a thrown body, or for a body that is held at a point, with the keys it needs.
  std::optional<Counterpart> gravityCounterpart(const ForeignNames& row, const std::string& path) const {
    const Node& given = *values_.at(path);
    if (isNoGravity(given))
      return Counterpart{{std::string(nameOf(path))}, "", {}, "", "There is no gravity without this key."};
    const bool top = mentions("body.pivot") || mentions("motion.lean") || mentions("motion.precession") ||
                     mentions("motion.nutation") || mentions("motion.euler");
    if (isThrown() || (!top && mentions("motion.") && !knownValue("motion.spin"))) return freeFall(given, path);
    const Key& key = *findKey("motion.gravity.g");
    auto carried = carriedValue(key, given, leaves_.limits);
    if (const std::string_view g = gravityWord(given); !g.empty()) carried = g;
    Counterpart counterpart{{std::string(nameOf(path))},
                            key.path,
                            carried ? std::vector<KeyLine>{{"g", *carried}} : exampleOf(key),
                            "",
                            std::string(row.note)};
    if (!mentions("body.mass") && !mentions("body.density") && !mentions("body.part["))
      counterpart.lines.push_back({"mass", "1", "body"});
    if (!mentions("body.pivot")) counterpart.lines.push_back({"pivot", pivotText(leaves_), "body"});
    return counterpart;
  }

  static bool isNoGravity(const Node& given) {
    const auto* text = given.as<std::string>();
    const auto* flag = given.as<bool>();
    const std::string word = text && text->size() <= kLongestName ? plainWord(*text) : "";
    return (flag && !*flag) || numberIn(given) == 0.0 || word == "none" || word == "off" || word == "zero" ||
           word == "no" || word == "false";
  }

  static std::string_view gravityWord(const Node& given) {
    const auto* text = given.as<std::string>();
    return text && text->size() <= kLongestName ? gravityOn(plainWord(*text)) : "";
  }

  /// Returns the key of a steady precession, with gravity if the scene lacks it.
  std::optional<Counterpart> steadyCounterpart(const ForeignNames& row, const std::string& path) const {
    Counterpart counterpart{{std::string(nameOf(path))},
                            std::string(row.key),
                            {{"precession", "\"slow\""}},
                            std::string(row.with),
                            std::string(row.note)};
    if (mentions("motion.gravity")) return counterpart;
    counterpart.lines.push_back({"g", "9.81", "motion.gravity"});
    if (!mentions("body.pivot")) counterpart.lines.push_back({"pivot", pivotText(leaves_), "body"});
    return counterpart;
  }

  std::optional<Counterpart> freeFall(const Node& given, const std::string& path) const {
    const Key& key = *findKey("motion.flight.gravity");
    std::string value = "[0, 0, -9.81]";
    if (const auto number = numberIn(given)) value = fmt::format("[0, 0, {:g}]", -std::abs(*number));
    if (const std::string_view g = gravityWord(given); !g.empty())
      value = fmt::format("[0, 0, -{}]", g);
    else if (given.as<std::string>() && !carriedValue(key, given, leaves_.limits))
      return std::nullopt;
    else if (given.as<std::string>() || given.as<Node::Array>())
      value = carriedValue(key, given, leaves_.limits).value_or(value);
    return Counterpart{{std::string(nameOf(path))},
                       key.path,
                       {{"gravity", value}},
                       "",
                       "It makes a free body fall. motion.gravity.g pulls a top, which body.pivot holds."};
  }

  // ---- rotation

  bool hasBody() const {
    return mentions("body.principal") || mentions("body.inertia") || knownValue("body.shape");
  }

  bool isBox(const std::string& path) const {
    const Node* shape = anyValueOf(path, "shape");
    const auto* word = shape ? shape->as<std::string>() : nullptr;
    return word && nearestShape(*word) == "box";
  }

  /// Returns the other unknown name of the table whose foreign names lead to a key, with a value that fits.
  const UnknownName* siblingFor(const std::string& path, std::string_view key, bool scalar) const {
    for (const UnknownName& name : names_) {
      if (name.path == path || tableOf(name.path) != tableOf(path) || taken_.contains(name.path)) continue;
      if (scalar && name.value->as<Node::Array>()) continue;
      const auto rows = plausibleRows(ours(name.path));
      if (!rows.empty() && rows[0]->key == key && rows[0]->carry == Carry::kValue) return &name;
    }
    return nullptr;
  }

  /// Returns the angular velocity for a magnitude and an axis, which are two names of one table.
  std::optional<Counterpart> directedCounterpart(const std::string& key, const std::string& path) const {
    const bool isAxis = key == "motion.spin_axis", isSpeed = key == "motion.omega_body";
    if (!isAxis && !(isSpeed && isScalar(*values_.at(path)))) return std::nullopt;
    const UnknownName* other = siblingFor(path, isAxis ? "motion.omega_body" : "motion.spin_axis", isAxis);
    if (!other) return std::nullopt;
    const Node *magnitude = isAxis ? other->value : values_.at(path),
               *axis = isAxis ? values_.at(path) : other->value;
    const ForeignNames row{"", "motion.omega_body", "", "Its components are along the body's axes.",
                           Carry::kDirected};
    auto lines = carriedLines(row, *findKey(row.key), {magnitude, axis}, leaves_.limits);
    if (lines.empty()) return std::nullopt;
    return Counterpart{{std::string(nameOf(path)), std::string(nameOf(other->path))},
                       std::string(row.key),
                       std::move(lines),
                       "",
                       std::string(row.note)};
  }

  // ---- angles

  /// Returns roll, pitch and yaw for three angles, if the scene names a sequence such as "321" or "xyz".
  std::optional<Counterpart> otherSequence(const ForeignNames& row, const std::string& path) const {
    if (!row.key.starts_with("motion.euler.")) return std::nullopt;
    for (const UnknownName& name : names_) {
      const auto* text = name.value->as<std::string>();
      if (tableOf(name.path) != tableOf(path) || !text || text->size() > 20) continue;
      const std::string sequence = plainWord(*text);
      const bool reversed = sequence == "321" || sequence == "zyx" || sequence == "3_2_1" || sequence == "ypr",
                 direct = sequence == "xyz" || sequence == "123" || sequence == "rpy" || sequence == "1_2_3";
      if (!reversed && !direct) continue;
      const ForeignNames other{"",
                               "motion.roll_pitch_yaw",
                               "",
                               "The order is roll, pitch, yaw.",
                               reversed ? Carry::kReversed : Carry::kValue,
                               row.unit};
      auto counterpart =
          ofRow(other, path, path, carriedLines(other, *findKey(other.key), {values_.at(path)}, leaves_.limits));
      if (counterpart && !taken_.contains(name.path)) counterpart->names.emplace_back(nameOf(name.path));
      return counterpart;
    }
    return std::nullopt;
  }

  // ---- film

  /// Returns the length of the film and its speed, if names of a table give the time of the motion and the length
  /// of the film.
  std::optional<Counterpart> filmCounterpart(const std::string& path) const {
    Counterpart counterpart{
        {},
        "time.duration",
        {},
        "",
        "It is the length of the film; time.speed is the seconds of motion per second of film."};
    const Node *film = nullptr, *span = nullptr;
    for (const UnknownName& name : names_) {
      if (tableOf(name.path) != tableOf(path)) continue;
      const auto rows = plausibleRows(name.path);
      const bool isSpan = !rows.empty() && rows[0]->carry == Carry::kFilm && nameOf(name.path) != "stop" &&
                          nameOf(name.path) != "end" && nameOf(name.path) != "until" && nameOf(name.path) != "to";
      const Node*& found = isSpan ? span : film;
      if (found || !(isSpan || isOfFilm(nameOf(name.path))) || !secondsIn(name.value)) continue;
      found = name.value;
      counterpart.names.emplace_back(nameOf(name.path));
    }
    const Node* known = knownValue("time.duration");
    auto span_s = secondsIn(span);
    if (!span_s) span_s = betweenDates(path, counterpart);
    if (!span_s && film && known) {
      span_s = secondsIn(known);
      counterpart.replaced.emplace_back("duration");
    }
    if (!span_s || !(*span_s > 0)) return std::nullopt;
    const auto film_s = secondsIn(film ? film : known).value_or(kUsualFilm_s);
    if (!(film_s > 0)) return std::nullopt;
    if (film || !known) counterpart.lines.push_back({"duration", film ? tomlText(*film) : "\"20 s\""});
    if (!knownValue("time.speed")) counterpart.lines.push_back({"speed", numberText(*span_s / film_s)});
    if (counterpart.lines.empty()) return std::nullopt;
    if (std::ranges::find(counterpart.replaced, "start") != counterpart.replaced.end())
      counterpart.lines.push_back({"start", "0"});
    counterpart.key = pathBelow("time", counterpart.lines[0].name);
    return counterpart;
  }

  /// Returns the seconds between two dates or times that a table gives as its start and its end.
  std::optional<double> betweenDates(const std::string& path, Counterpart& counterpart) const {
    for (const std::string_view name : {"stop", "end", "until", "to"}) {
      const Node *stop = valueOf(path, name), *start = anyValueOf(path, "start");
      if (!stop) continue;
      const auto from = dateIn(start), to = dateIn(stop);
      const auto until = secondsIn(stop);
      if (!(from && to) && !until) continue;
      counterpart.names.emplace_back(name);
      if (!from || !to) return *until - secondsIn(start).value_or(0);
      counterpart.replaced.emplace_back("start");
      return *to - *from;
    }
    return std::nullopt;
  }

  // ---- things that are drawn

  std::optional<Counterpart> shownCounterpart(const std::string& path) const {
    const Node& given = *values_.at(path);
    Counterpart counterpart{{std::string(nameOf(path))}, "", {}, "", "Each thing has a key of its own in [show]."};
    Node::Array all = {given};
    const bool isConstruction =
        nameOf(path).find("poinsot") != std::string_view::npos || nameOf(path) == "construction";
    if (isConstruction && !given.as<Node::Array>())
      for (const char* name : {"ellipsoid", "plane", "polhode", "herpolhode"})
        all.push_back({std::string(name), given.place});
    const auto* array = given.as<Node::Array>();
    for (const Node& one : array ? *array : all) {
      const auto* word = one.as<std::string>();
      const std::string figure = word ? figureOf(*word) : "";
      if (figure.empty() || isOffered(counterpart, figure)) continue;
      if (counterpart.key.empty()) counterpart.key = fmt::format("show.{}.visible", figure);
      counterpart.lines.push_back({figure, "true", "show"});
    }
    return counterpart.key.empty() ? std::nullopt : std::optional(counterpart);
  }

  static bool isOffered(const Counterpart& counterpart, const std::string& name) {
    return std::ranges::find(counterpart.lines, name, &KeyLine::name) != counterpart.lines.end();
  }

  std::optional<Counterpart> plotCounterpart(const ForeignNames& row, const std::string& path) const {
    const auto carried = carriedValue(*findKey(row.key), *values_.at(path), leaves_.limits);
    return Counterpart{{std::string(nameOf(path))},
                       std::string(row.key),
                       {{"quantities", carried.value_or("[\"omega_1\", \"omega_2\", \"omega_3\"]"), "plot[]"}},
                       ""};
  }

  /// Returns the thing in [show] that draws an arrow, and its colour, in place of a [[vector]].
  std::optional<Counterpart> arrowCounterpart(const std::string& path) const {
    const auto* word = values_.at(path)->as<std::string>();
    return word ? arrowOf(*word, path) : std::nullopt;
  }

  /// Returns the thing in [show] for a [[vector]] that has its name and no components.
  std::optional<Counterpart> namedArrow(const std::string& path) const {
    const std::string table(tableOf(path));
    if (!table.starts_with("vector[")) return std::nullopt;
    for (const std::string_view name : {"components", "position_of", "velocity_of"})
      if (knownValue(pathBelow(table, name))) return std::nullopt;
    for (const UnknownName& other : names_) {
      const auto rows =
          tableOf(other.path) == table ? plausibleRows(other.path) : std::vector<const ForeignNames*>();
      if (rows.empty() || rows[0]->key != "vector[].components") continue;
      return rows[0]->carry == Carry::kArrow ? arrowCounterpart(other.path) : std::nullopt;
    }
    const Node* name = knownValue(pathBelow(table, "name"));
    const auto* word = name ? name->as<std::string>() : nullptr;
    return word ? arrowOf(*word, path) : std::nullopt;
  }

  std::optional<Counterpart> arrowOf(const std::string& word, const std::string& path) const {
    const std::string figure = figureOf(word);
    if (figure.empty()) return std::nullopt;
    Counterpart counterpart{{}, fmt::format("show.{}.visible", figure), {{figure, "true", "show"}}, ""};
    for (const UnknownName& name : names_)
      if (tableOf(name.path) == tableOf(path)) counterpart.names.emplace_back(nameOf(name.path));
    const std::string array(tableOf(path).substr(0, tableOf(path).find('[')));
    counterpart.instead = fmt::format("this {}", tableText(array));
    const Key* color = findKey("style.colors." + figure);
    const Node* given = anyValueOf(path, "color");
    for (const std::string_view name : {"colour", "c"})
      if (!given) given = anyValueOf(path, name);
    if (const auto carried = color && given ? carriedValue(*color, *given, leaves_.limits) : std::nullopt)
      counterpart.lines.push_back({figure, *carried, "style.colors"});
    for (const std::string_view name : {"color", "components", "position_of", "velocity_of"}) {
      leaves_.values.erase(pathBelow(tableOf(path), name));
      leaves_.meant.insert(pathBelow(tableOf(path), name));
    }
    return counterpart;
  }

  // ---- bodies

  /// Returns a ball for each of several masses on a line, or else a point mass for each.
  std::optional<Counterpart> pointsCounterpart(const ForeignNames& row, const std::string& path) const {
    const std::vector<const Node*> values = valuesOf(row, path);
    const auto* masses = values[0] ? values[0]->as<Node::Array>() : nullptr;
    const auto* places = values.size() > 1 && values[1] ? values[1]->as<Node::Array>() : nullptr;
    if (!masses || !places || masses->size() != places->size() || masses->empty() || masses->size() > 20)
      return std::nullopt;
    Counterpart counterpart{presentNames(row, path), "", {}, ""};
    const bool line = areOnALine(*places);
    const std::string array = line ? "body.part[]" : "body.point_mass[]", place = line ? "offset" : "position";
    const Key &mass = *findKey(array + ".mass"), &position = *findKey(pathBelow(array, place));
    if (line) counterpart.note = "Balls, because points on one line have no moment about it.";
    counterpart.key = mass.path;
    for (std::size_t i = 0; i < masses->size(); ++i) {
      const auto m = carriedValue(mass, (*masses)[i], leaves_.limits),
                 r = carriedValue(position, (*places)[i], leaves_.limits);
      if (!m || !r) return std::nullopt;
      const std::string table = fmt::format("{}{}", array, i);  // each is a table of its own
      if (line) {
        counterpart.lines.push_back({"shape", "\"sphere\"", table});
        counterpart.lines.push_back({"radius", ballRadius(*places), table});
      }
      counterpart.lines.push_back({"mass", *m, table});
      counterpart.lines.push_back({place, *r, table});
    }
    for (const std::string_view name : {"shape", "mass"})
      if (knownValue(pathBelow("body", name))) {
        counterpart.replaced.emplace_back(name);
        leaves_.values.erase(pathBelow("body", name));
      }
    return counterpart;
  }

  static std::vector<std::array<double, 3>> pointsOf(const Node::Array& places) {
    std::vector<std::array<double, 3>> points;
    for (const Node& place : places) {
      const auto* three = place.as<Node::Array>();
      std::array<double, 3> point{};
      for (std::size_t i = 0; i < 3; ++i)
        point[i] = three && three->size() == 3 ? numberIn((*three)[i]).value_or(0) : 0;
      points.push_back(point);
    }
    return points;
  }

  static bool areOnALine(const Node::Array& places) {
    const auto points = pointsOf(places);
    const auto difference = [&](std::size_t i) {
      return std::array{points[i][0] - points[0][0], points[i][1] - points[0][1], points[i][2] - points[0][2]};
    };
    for (std::size_t i = 1; i < points.size(); ++i)
      for (std::size_t k = 1; k < i; ++k) {
        const auto a = difference(i), b = difference(k);
        if (a[1] * b[2] != a[2] * b[1] || a[2] * b[0] != a[0] * b[2] || a[0] * b[1] != a[1] * b[0]) return false;
      }
    return true;
  }

  /// Returns a fifth of the largest coordinate as the radius of a ball.
  static std::string ballRadius(const Node::Array& places) {
    double largest = 0;
    for (const auto& point : pointsOf(places))
      for (const double x : point) largest = std::max(largest, std::abs(x));
    return numberText(largest > 0 && std::isfinite(largest) ? largest / 5 : 0.1);
  }

  /// Returns the height of a cylinder, or the three sides of a box, for a thickness or a depth.
  std::optional<Counterpart> sidesCounterpart(const std::string& path) const {
    const std::string table(tableOf(path));
    const std::string_view name = nameOf(path);
    if (!findKey(pathBelow(table, "shape")) || (name != "thickness" && name != "depth")) return std::nullopt;
    const Node *shape = anyValueOf(path, "shape"), *given = values_.at(path);
    const auto* text = shape ? shape->as<std::string>() : nullptr;
    const std::string word = text ? nearestShape(*text) : "";
    if (isRound(word) || (word.empty() && anyValueOf(path, "radius"))) {
      const auto height = carriedValue(*findKey("body.height"), *given, leaves_.limits);
      if (!height) return std::nullopt;
      Counterpart counterpart{
          {std::string(name)}, pathBelow(table, "height"), {{"shape", "\"cylinder\""}, {"height", *height}}, ""};
      if (word == "cylinder")
        counterpart.lines.erase(counterpart.lines.begin());
      else
        counterpart.replaced = {"shape"};
      if (word != "cylinder") counterpart.note = "A disc with a thickness is a cylinder.";
      return counterpart;
    }
    if (word == "hollow_box") return std::nullopt;
    return boxOf(path, word);
  }

  std::optional<Counterpart> boxOf(const std::string& path, const std::string& word) const {
    std::vector<Node> sides;
    Counterpart counterpart{{}, pathBelow(tableOf(path), "size"), {}, "mass = 1"};
    if (const Node* size = anyValueOf(path, "size"))
      if (const auto* two = size->as<Node::Array>(); two && two->size() == 2) {
        sides = *two;
        counterpart.replaced.emplace_back("size");
      }
    for (const std::string_view name : {"length", "width", "height", "depth", "thickness"})
      if (const Node* side = anyValueOf(path, name); side && sides.size() < 3) {
        sides.push_back(*side);
        if (valueOf(path, name))
          counterpart.names.emplace_back(name);
        else
          counterpart.replaced.emplace_back(name);
      }
    if (sides.size() != 3) return std::nullopt;
    const auto size =
        carriedValue(*findKey("body.size"), listNode(std::move(sides), values_.at(path)->place), leaves_.limits);
    if (!size) return std::nullopt;
    if (word == "plate" || word.empty()) {
      counterpart.lines.push_back({"shape", "\"box\""});
      if (word == "plate") counterpart.replaced.emplace_back("shape");
    }
    counterpart.lines.push_back({"size", *size});
    for (const std::string& name : counterpart.replaced)
      if (name != "shape") leaves_.values.erase(pathBelow(tableOf(path), name));
    return counterpart;
  }

  /// Returns the key body.shape for the name of a shape, such as "cylinder" or "cuboid".
  std::optional<Counterpart> shapeCounterpart(const std::string& path) const {
    if (!tableOf(path).empty() && tableOf(path) != "body") return std::nullopt;
    const std::string name = core::lowered(nameOf(path));
    const std::string_view other = wordElsewhere(name);
    const std::vector<std::string_view> words = shapeWords();
    std::string_view word = std::ranges::find(words, name) == words.end() ? other : std::string_view(name);
    if (std::ranges::find(words, word) == words.end()) return std::nullopt;
    const ForeignNames row{"", "body.shape"};
    return ofRow(row, path, path, {{"shape", fmt::format("\"{}\"", word)}});
  }

  /// Returns the key of a name with a unit at its end, such as body.mass for body.mass_kg.
  /// @param at  path of the name in our tables
  std::optional<Counterpart> unitCounterpart(const std::string& path, const std::string& at) const {
    for (std::size_t end = at.find('_', at.rfind('.') + 1); end != std::string::npos; end = at.find('_', end + 1))
      if (auto counterpart = withUnit(at.substr(0, end), at.substr(end + 1), path)) {
        if (counterpart->names.empty() || takesOne(*counterpart, at.substr(0, end)))
          counterpart->names = {std::string(nameOf(path))};
        return counterpart;
      }
    return std::nullopt;
  }

  static bool takesOne(const Counterpart& counterpart, std::string_view stem) {
    return counterpart.names.size() == 1 && counterpart.names[0] == nameOf(stem);
  }

  std::optional<Counterpart> withUnit(const std::string& stem, const std::string& suffix,
                                      const std::string& path) const {
    std::vector<ForeignNames> rows;
    const std::string own = findKey(stem) ? patternOf(stem) : "";
    if (!own.empty()) rows.push_back({"", own});
    for (const ForeignNames* row : plausibleRows(stem)) rows.push_back(*row);
    const std::string other = rows.empty() ? sameName(nameOf(stem)).value_or("") : "";
    if (!other.empty()) rows.push_back({"", other});
    for (ForeignNames& row : rows) {
      if (row.key.empty() || !takesUnit(row.carry)) continue;
      const Key& key = *findKey(row.key);
      const bool isTime = row.carry == Carry::kPeriod || row.carry == Carry::kInterval;
      row.unit = unitOf(suffix, isTime ? Dimension::kTime : key.dimension);
      if (row.unit.empty()) continue;
      if (auto three = otherSequence(row, path)) return three;
      std::vector<KeyLine> lines = carriedLines(row, key, {values_.at(path)}, leaves_.limits);
      if (lines.empty() && row.carry != Carry::kValue) continue;
      return ofRow(row, stem, stem, lines.empty() ? exampleOf(key) : std::move(lines));
    }
    return std::nullopt;
  }

  static bool takesUnit(Carry carry) {
    return carry == Carry::kValue || carry == Carry::kPeriod || carry == Carry::kInterval ||
           carry == Carry::kEuler || carry == Carry::kReversed || carry == Carry::kBelow;
  }

  /// Returns the unit at the end of a name, kept for as long as the program runs.
  static std::string_view unitOf(const std::string& suffix, Dimension dimension) {
    static thread_local std::set<std::string, std::less<>> units;
    const std::string unit = unitInName(suffix, dimension);
    return unit.empty() ? std::string_view() : std::string_view(*units.insert(unit).first);
  }

  /// Returns the key of a misspelt name, if its value needs another form.
  std::optional<Counterpart> misspeltCounterpart(const std::string& path, const Node& value) const {
    const auto near = misspelt(tableOf(path), nameOf(path));
    const Key* key = near ? findKey(*near) : nullptr;
    if (near && hasVisible(*near) && value.as<bool>())
      return Counterpart{{std::string(nameOf(path))},
                         *near + ".visible",
                         {{std::string(nameOf(*near)), tomlText(value), std::string(tableOf(*near))}},
                         ""};
    const auto carried = key ? carriedValue(*key, value, leaves_.limits) : std::nullopt;
    if (!carried || *carried == tomlText(value)) return std::nullopt;
    return Counterpart{{std::string(nameOf(path))}, *near, {{std::string(nameOf(*near)), *carried}}, ""};
  }

  /// Returns a key with the name in another table. Its own table has no similar name.
  std::optional<Counterpart> keyElsewhere(const std::string& path, const Node& value) const {
    if (misspelt(tableOf(path), nameOf(path))) return std::nullopt;
    const auto other = otherKey(path);
    const Key* key = other ? findKey(*other) : nullptr;
    if (!key || key->path.find('[') != std::string::npos) return std::nullopt;
    const auto carried = carriedValue(*key, value, leaves_.limits);
    std::vector<KeyLine> lines = exampleOf(*key);
    if (carried) lines = {{std::string(nameOf(key->path)), *carried}};
    if (lines.empty()) return std::nullopt;
    return Counterpart{{std::string(nameOf(path))}, *other, std::move(lines), "", ""};
  }

  /// Returns the keys that have the most words in common with a name.
  std::optional<Counterpart> similarCounterpart(const std::string& path, const std::string& at,
                                                const Node& value) const {
    const auto other = otherKey(path);
    if (other && other->find("[]") == std::string::npos && !findKey(*other)) return std::nullopt;
    const auto near = misspelt(tableOf(path), nameOf(path));
    const Key* nearKey = near ? findKey(*near) : nullptr;
    if (near && (!nearKey || carriedValue(*nearKey, value, leaves_.limits))) return std::nullopt;
    const auto takes = [&](const Key& key) { return carriedValue(key, value, leaves_.limits).has_value(); };
    std::vector<const Key*> keys = similarKeys(at, takes);
    const auto isKnown = [&](const Key* key) { return leaves_.values.contains(key->path); };
    if (!std::ranges::all_of(keys, isKnown)) std::erase_if(keys, isKnown);
    if (keys.empty()) return std::nullopt;
    const bool isElement = keys[0]->path.find('[') != std::string::npos;  // of the same element as the name
    Counterpart counterpart{{std::string(nameOf(path))},
                            isElement ? pathBelow(tableOf(path), nameOf(keys[0]->path)) : keys[0]->path,
                            {},
                            ""};
    for (const Key* key : keys) {
      std::vector<KeyLine> lines = exampleOf(*key);
      if (const auto carried = carriedValue(*key, value, leaves_.limits)) lines = {{"", *carried}};
      if (!lines.empty()) counterpart.choices.emplace_back(key, lines[0].value);
    }
    if (counterpart.choices.size() != 1) return counterpart;
    counterpart.note = shortHelp(*keys[0]);
    if (!counterpart.note.ends_with('.')) counterpart.note += '.';
    counterpart.lines = {{std::string(nameOf(keys[0]->path)), counterpart.choices[0].second}};
    counterpart.choices.clear();
    return counterpart;
  }

  // ---- tables

  /// Returns a key below a table for a value that stands in place of the table.
  std::optional<Counterpart> valueInPlaceOfTable(const std::string& path) const {
    if (path == "show") return shownCounterpart(path);
    if (auto foreign = foreignCounterpart(path, path)) return foreign;
    const Node& value = *values_.at(path);
    if (hasVisible(path)) {
      const auto flag = carriedValue(*findKey(path + ".visible"), value, leaves_.limits);
      return Counterpart{{},
                         path + ".visible",
                         {{std::string(nameOf(path)), flag.value_or("true"), std::string(tableOf(path))}},
                         ""};
    }
    const Key* example = nullptr;
    for (const std::string& name : namesBelow(path)) {
      const Key* key = findKey(pathBelow(path, name));
      if (!key || key->type == ValueType::kBool) continue;
      if (const auto carried = carriedValue(*key, value, leaves_.limits))
        return Counterpart{{}, key->path, {{name, *carried}}, ""};
      if (!example && !exampleOf(*key).empty()) example = key;
    }
    if (!example || tableOf(path).empty()) return std::nullopt;
    return Counterpart{{}, example->path, exampleOf(*example), ""};
  }

  /// Returns the array of tables for a name such as "subplot"; empty for other names.
  static std::string arrayNamed(const std::string& path) {
    const std::string name = core::lowered(nameOf(path.substr(0, path.find('['))));
    if (!tableOf(path).empty() && tableOf(path) != "body") return "";
    for (const auto& [names, array] :
         {std::pair<std::string_view, std::string_view>{
              " subplot subplots plots graph graphs chart curve panel axes figure ", "plot"},
          {" arrow arrows vectors ", "vector"},
          {" bodies part parts component components link solid solids piece pieces primitive body.parts ",
           "body.part"},
          {" point_mass point_masses pointmass mass masses particle particles points ", "body.point_mass"},
          {" event events keyframe keyframes ", "timeline"},
          {" text texts annotation annotations ", "note"},
          {" views window ", "view"}})
      if (names.find(" " + name + " ") != std::string_view::npos) return std::string(array);
    return "";
  }

  /// Returns the tables of an array for tables of another name, with each name that this program has.
  std::optional<Counterpart> elementsOf(const std::string& array, const std::string& path) const {
    const auto* elements = values_.at(path)->as<Node::Array>();
    if (!elements || elements->empty() || elements->size() > 20) return std::nullopt;
    Counterpart counterpart{{std::string(nameOf(path))}, "", {}, ""};
    for (std::size_t i = 0; i < elements->size(); ++i) {
      const auto* entries = (*elements)[i].as<Node::Table>();
      if (!entries) return std::nullopt;
      for (const Entry& entry : *entries) addElement(counterpart, fmt::format("{}[]", array), i, entry);
    }
    if (counterpart.key.empty()) return std::nullopt;
    counterpart.instead = fmt::format("[[{}]]", core::printable(path));
    return counterpart;
  }

  void addElement(Counterpart& counterpart, const std::string& table, std::size_t i, const Entry& entry) const {
    if (entry.key.find_first_of(".[]") != std::string::npos || entry.key.size() > kLongestName) return;
    const std::string path = pathBelow(table, entry.key);
    const Key* key = findKey(path);
    for (const ForeignNames* row : plausibleRows(path)) {
      if (key || row->key.empty()) continue;
      key = findKey(keyFor(*row, path));
      if (key && tableOf(key->path) != table) key = nullptr;
    }
    const auto carried = key ? carriedValue(*key, entry.value, leaves_.limits) : std::nullopt;
    if (!carried) return;
    if (counterpart.key.empty()) counterpart.key = key->path;
    counterpart.lines.push_back({std::string(nameOf(key->path)), *carried, fmt::format("{}{}", table, i)});
  }

  // ---- messages

  std::string messageOf(const UnknownName& unknown, const std::optional<Counterpart>& counterpart) {
    if (unknown.isTable && counterpart && counterpart->key.empty())
      return fmt::format("{0}: expected a table [{0}], got {1}; leave it out. {2}", unknown.path,
                         describe(*unknown.value), counterpart->note);
    if (unknown.isTable)
      return fmt::format("{0}: expected a table [{0}]{1}, got {2}{3}", unknown.path,
                         hasVisible(unknown.path) ? ", true or false" : "", describe(*unknown.value),
                         counterpart ? advice(unknown.path, unknown.place, *counterpart) : "");
    std::vector<std::string> names;
    for (const std::string& name : counterpart->names) names.push_back(core::printable(name));
    const std::string path = pathBelow(tableOf(unknown.path), core::joined(names, ", "));
    const std::string start = fmt::format("{}: unknown key{}", core::printable(path), names.size() > 1 ? "s" : "");
    if (counterpart->key.empty())
      return fmt::format("{}; leave {} out. {}", start, names.size() > 1 ? "them" : "it", counterpart->note);
    return start + advice(unknown.path, unknown.place, *counterpart);
  }

  /// Returns the question for the key and the lines to paste, for the end of a message. An override has no lines.
  std::string advice(const std::string& path, const Place& place, const Counterpart& counterpart) {
    std::string text = fmt::format("; did you mean {}?", nameInText(counterpart));
    if (!counterpart.note.empty()) text += fmt::format(" {}", counterpart.note);
    const bool replaces =
        std::ranges::find(counterpart.replaced, nameOf(counterpart.key)) != counterpart.replaced.end();
    if (counterpart.choices.empty() && !replaces && leaves_.values.contains(counterpart.key) &&
        counterpart.instead.empty())
      return text + " The scene gives it too; leave this line out.";
    if (!place.source->hasLines()) return text;
    if (!offered_.insert(counterpart.key).second)
      return text + " An earlier message gives it; leave this line out.";
    return text + (counterpart.choices.empty() ? pasted(path, counterpart) : oneOf(counterpart)) +
           counterpart.otherwise;
  }

  static std::string nameInText(const Counterpart& counterpart) {
    if (counterpart.choices.empty()) {
      const bool isArray = counterpart.key.find("[].") != std::string::npos;
      return isArray ? tableText(tableOf(counterpart.key)) : counterpart.key;
    }
    KeyNames names;
    for (const auto& [key, value] : counterpart.choices) names.push_back(key->path);
    std::string text = listed(names);
    return text.replace(text.rfind(" and "), 5, " or ");
  }

  /// Returns one line for each of several keys, with its table and its help.
  static std::string oneOf(const Counterpart& counterpart) {
    std::string text = " For example, one of:";
    for (const auto& [key, value] : counterpart.choices) {
      const bool isThing = key->path.ends_with(".visible");
      const std::string_view line = isThing ? tableOf(key->path) : std::string_view(key->path);
      text += fmt::format("\n    {} = {}  # in {}: {}", nameOf(line), value, tableText(tableOf(line)),
                          shortHelp(*key));
    }
    return text;
  }

  std::string pasted(const std::string& path, const Counterpart& counterpart) {
    const std::string table(tableOf(counterpart.key));
    std::vector<KeyLine> lines = otherLines(counterpart, table);
    lines.insert(lines.end(), counterpart.lines.begin(), counterpart.lines.end());
    std::string text;
    for (std::size_t i = 0; i < lines.size();) {
      std::vector<KeyLine> group;
      const std::string& of = lines[i].table;
      for (; i < lines.size() && lines[i].table == of; ++i) group.push_back(lines[i]);
      text += placed(path, of.empty() ? table : of, group, text.empty() ? instead(counterpart) : "", text.empty());
    }
    return text;
  }

  static std::string instead(const Counterpart& counterpart) {
    if (!counterpart.instead.empty()) return ", in place of " + counterpart.instead;
    if (counterpart.replaced.empty()) return "";
    return ", in place of " + listed(KeyNames(counterpart.replaced.begin(), counterpart.replaced.end()));
  }

  /// Returns lines of one table with the place where they belong.
  /// @param first  whether these are the first lines of a message
  std::string placed(const std::string& path, std::string table, const std::vector<KeyLine>& lines,
                     const std::string& instead, bool first) {
    const bool isElement = table.find("[]") != std::string::npos;
    const std::string begin = (first ? " For example" : "\n  and") + instead;
    const auto in = [&](std::string_view where) {
      return fmt::format("{}{}{}:", begin, first && !where.empty() ? ", " : where.empty() ? "" : " ", where);
    };
    if (isElement) {
      const std::string header = tableText(table.substr(0, table.find("[]") + 2));
      const std::string_view index = std::string_view(table).substr(table.find("[]") + 2);
      if (!index.empty() && index != "0") return fmt::format("\n    {}{}", header, textOf(lines, ""));
      return fmt::format("{}\n    {}{}", in("at the end of the file"), header, textOf(lines, ""));
    }
    if (table == tableOf(path)) return in(first ? "" : "in " + tableText(table)) + textOf(lines, "");
    const std::string_view opening = lineOf(table);
    if (opened_.contains(table) || opening.starts_with(tableText(table)))
      return in("in " + tableText(table)) + textOf(lines, "");
    if (!opening.empty() && !opening.starts_with('['))  // keys with dots, after which TOML allows no header
      return in("at the top of the file") + textOf(lines, table + ".");
    if (!tableOf(path).empty() && table.starts_with(std::string(tableOf(path)) + "."))
      return in("") + textOf(lines, table.substr(tableOf(path).size() + 1) + ".");
    opened_.insert(table);
    return fmt::format("{}\n    {}{}", in("at the end of the file"), tableText(table), textOf(lines, ""));
  }

  /// Returns the line that makes a table: a header such as "[motion]", or a key with dots. Empty if there is none.
  std::string_view lineOf(const std::string& table) const {
    const auto found = leaves_.tables.find(table);
    return found == leaves_.tables.end() ? "" : core::trimmed(found->second.source->line(found->second.line));
  }

  static std::string textOf(const std::vector<KeyLine>& lines, const std::string& prefix) {
    std::string text;
    for (const KeyLine& line : lines) text += fmt::format("\n    {}{} = {}", prefix, line.name, line.value);
    return text;
  }

  /// Returns lines for the other keys that a key needs and that the scene does not give in any way.
  std::vector<KeyLine> otherLines(const Counterpart& counterpart, const std::string& table) {
    std::vector<KeyLine> lines = parsedLines(counterpart.with);
    const bool hasShape = counterpart.with.find("shape") != std::string::npos && isGiven(table, "shape");
    const KeyNames& lengths = shapeKeyNames();
    std::erase_if(lines, [&](const KeyLine& line) {
      const bool isLength = std::ranges::find(lengths, line.name) != lengths.end();
      return (hasShape && isLength) || isGiven(table, line.name);  // a shape reports its missing lengths by itself
    });
    for (KeyLine& line : lines) {
      offered_.insert(pathBelow(table, line.name));
      leaves_.meant.insert(pathBelow(table, line.name));  // a second message on it would say the same
      if (line.name == "spin_axis") line.value = spinAxisText(leaves_);
    }
    return lines;
  }

  /// Returns whether the scene, or an earlier example, gives a key or another key instead of it.
  bool isGiven(const std::string& table, const std::string& name) const {
    using Names = std::vector<std::string_view>;
    static const std::vector<std::pair<Names, Names>> alternatives = {
        {{"mass"}, {"density"}},
        {{"lean"}, {"tilt", "orientation", "roll_pitch_yaw"}},
        {{"density"}, {"mass"}},
        {{"shape"}, {"principal_moments", "inertia", "catalogue"}},
        {{"size"}, {"radius", "height", "length", "edge"}},
        {{"radius", "height", "length", "edge"}, {"size"}},
    };
    const auto known = [&](std::string_view one) {
      const std::string path = pathBelow(table, one);
      return leaves_.values.contains(path) || leaves_.meant.contains(path) || offered_.contains(path);
    };
    return known(name) || std::ranges::any_of(alternatives, [&](const auto& pair) {
             return std::ranges::find(pair.first, name) != pair.first.end() &&
                    std::ranges::any_of(pair.second, known);
           });
  }

  std::vector<UnknownName> names_;
  Leaves& leaves_;
  Problems& problems_;
  std::map<std::string, const Node*, std::less<>> values_;
  std::set<std::string, std::less<>> taken_;    ///< paths of names that an earlier message contains
  std::set<std::string, std::less<>> offered_;  ///< keys in earlier examples
  std::set<std::string, std::less<>> opened_;   ///< tables that earlier examples begin
};

}  // namespace

std::string figureOf(std::string_view word) {
  std::string name = plainWord(word.substr(0, word.find('(')));
  if (name == "l" || name == "h" || name == "angular_momentum") name = "L";
  if (name == "w" || name == "angular_velocity" || name == "spin" || name == "rotation") name = "omega";
  if (name == "axes" || name == "body_axes" || name == "principal_axes" || name == "frame")
    name = "principal_axes";
  if (name == "space_cone" || name == "body_cone") name = "cones";
  if (name == "inertia_ellipsoid" || name == "poinsot_ellipsoid" || name == "energy_ellipsoid") name = "ellipsoid";
  if (name == "invariable_plane") name = "plane";
  if (name == "velocity" || name == "v" || name == "weight") name = "flight";
  return hasVisible("show." + name) ? name : "";
}

void reportUnknown(std::vector<UnknownName> names, Leaves& leaves, Problems& problems) {
  Report(std::move(names), leaves, problems).run();
}

std::string adviceFor(const std::string& path, const Node& value, Leaves& leaves) {
  Problems none;
  return Report({}, leaves, none).adviceFor(path, value);
}

}  // namespace poinsot::scene
