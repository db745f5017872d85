// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/value_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <utility>

#include "core/text.h"
#include "scene/document/arithmetic.h"
#include "scene/keys/foreign_words.h"

namespace poinsot::scene {
namespace {

// Far longer than any number or list of numbers that a person writes into one text.
constexpr std::size_t kLongestText = 200;

/// Returns a number as an integer if it is whole, so that a message shows 2 and not 2.0.
Node numberAt(double number, const Place& place) {
  if (number == std::round(number) && std::abs(number) < 1e15) return {static_cast<std::int64_t>(number), place};
  return {number, place};
}

/// Returns the number of a text that contains nothing else; a comma counts as the decimal point.
std::optional<double> plainNumber(std::string_view text) {
  std::string point(core::trimmed(text));
  if (std::ranges::count(point, ',') == 1) std::ranges::replace(point, ',', '.');
  if (point.starts_with('+')) point.erase(0, 1);
  double number = 0;
  const char* end = point.data() + point.size();
  const auto read = std::from_chars(point.data(), end, number);
  if (point.empty() || read.ec != std::errc() || read.ptr != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// Returns the factor of a text such as "8x", "x8", "1/4", "1:4", "10%" and "2 times".
std::optional<double> factorIn(std::string_view text) {
  std::string word = core::lowered(core::trimmed(text));
  for (const std::string_view mark : {"times", "×", "x", "fold"}) {
    if (word.ends_with(mark)) word = word.substr(0, word.size() - mark.size());
    if (word.starts_with(mark)) word.erase(0, mark.size());
  }
  if (const std::size_t slash = word.find_first_of("/:"); slash != std::string::npos) {
    const auto above = plainNumber(word.substr(0, slash)), below = plainNumber(word.substr(slash + 1));
    if (!above || !below || *below == 0) return std::nullopt;
    return *above / *below;
  }
  if (word.ends_with('%'))
    if (const auto percent = plainNumber(std::string_view(word).substr(0, word.size() - 1))) return *percent / 100;
  return plainNumber(word);
}

/// Returns a quantity whose words are spelled out, or that has a decimal comma, as this program reads it: "3
/// rev/s" for "3 rotations per second".
std::optional<std::string> quantityFor(std::string_view given, Dimension dimension) {
  if (dimension == Dimension::kNone || given.size() > kLongestText) return std::nullopt;
  using Word = std::pair<std::string_view, std::string_view>;
  std::string text(given);
  for (const auto& [word, unit] :
       {Word{"min^-1", "rpm"},    Word{"1/min", "rpm"},    Word{"U/min", "rpm"}, Word{" per ", "/"},
        Word{"rotations", "rev"}, Word{"rotation", "rev"}, Word{"turns", "rev"}, Word{"degrees", "deg"},
        Word{"radians", "rad"},   Word{"seconds", "s"},    Word{"second", "s"},  Word{"sec", "s"},
        Word{"minutes", "min"},   Word{"minute", "min"},   Word{"hours", "h"},   Word{"hour", "h"},
        Word{"days", "d"},        Word{"meters", "m"},     Word{"metres", "m"},  Word{"meter", "m"},
        Word{"kilograms", "kg"},  Word{"grams", "g"},      Word{"centi", "c"},   Word{"milli", "m"},
        Word{"cubic m", "m^3"},   Word{"squared", "^2"}})
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + unit.size()))
      text.replace(at, word.size(), unit);
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos && comma + 1 < text.size() &&
      std::isdigit(static_cast<unsigned char>(text[comma + 1])))
    text[comma] = '.';
  const auto isQuantity = [&](const std::string& one) { return parseQuantity(one, dimension).ok(); };
  if (text != given && isQuantity(text)) return text;
  return std::nullopt;
}

/// Returns a single value, or each element of an array, as this program reads it.
std::optional<Node> spelledOut(const Node& given, Dimension dimension) {
  if (const auto* array = given.as<Node::Array>()) {
    std::vector<Node> elements;
    for (const Node& element : *array) {
      const auto one = spelledOut(element, dimension);
      elements.push_back(one ? *one : element);
    }
    return listNode(std::move(elements), given.place);
  }
  const auto* text = given.as<std::string>();
  if (!text || text->size() > kLongestText) return std::nullopt;
  if (const auto number = plainNumber(*text)) return numberAt(*number, given.place);
  if (const auto value = arithmeticIn(*text))
    return numberAt(std::strtod(fmt::format("{:.7g}", *value).c_str(), nullptr), given.place);
  const auto quantity = quantityFor(*text, dimension);
  return quantity ? std::optional(Node{*quantity, given.place}) : std::nullopt;
}

/// Returns numbers with the unit at the end of a text: "0 0 3 rpm".
std::optional<Node> numbersWithUnit(const Node& given, Dimension dimension) {
  const auto* whole = given.as<std::string>();
  if (!whole || whole->size() > kLongestText || dimension == Dimension::kNone) return std::nullopt;
  std::string text = *whole;
  for (std::size_t i = 1; i + 1 < text.size(); ++i)  // 30x20x10 cm
    if (text[i] == 'x' && std::string_view("0123456789 .").find(text[i + 1]) != std::string_view::npos)
      text[i] = ' ';
  const std::size_t letter = text.find_first_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
  if (letter == std::string::npos || letter == 0) return std::nullopt;
  const std::string unit(core::trimmed(std::string_view(text).substr(letter)));
  const auto numbers = numbersIn({text.substr(0, letter), given.place});
  if (!numbers || !parseQuantity("1 " + unit, dimension).ok()) return std::nullopt;
  return withUnit(*numbers, unit, dimension);
}

/// Returns the value of an entry whose name is one of `names`, or ends with one: "omega_x" for "x".
const Node* entryNamed(const Node::Table& table, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    for (const Entry& entry : table) {
      const std::string key = core::lowered(entry.key);
      const bool axis = name.size() == 1 && key.size() > 1 && key.ends_with(name) && key.size() <= 8;
      if (key == name || axis) return &entry.value;
    }
  return nullptr;
}

/// Returns three elements of a table, in the order of an array. Missing elements are 0.
std::optional<Node> threeIn(const Node::Table& table, const Place& place) {
  using Names = std::initializer_list<std::string_view>;
  for (const std::array<Names, 3>& names :
       {std::array<Names, 3>{Names{"xx"}, Names{"yy"}, Names{"zz"}},
        std::array<Names, 3>{Names{"length"}, Names{"width"}, Names{"height", "thickness", "depth"}},
        std::array<Names, 3>{Names{"roll"}, Names{"pitch"}, Names{"yaw", "heading"}},
        std::array<Names, 3>{Names{"precession", "phi"}, Names{"nutation", "theta"}, Names{"spin", "psi"}},
        std::array<Names, 3>{Names{"x"}, Names{"y"}, Names{"z"}},
        std::array<Names, 3>{Names{"1"}, Names{"2"}, Names{"3"}}}) {
    std::vector<Node> elements;
    std::size_t found = 0;
    for (const Names& one : names) {
      const Node* entry = entryNamed(table, one);
      if (entry && !isScalar(*entry)) return std::nullopt;
      elements.push_back(entry ? *entry : zeroAt(place));
      found += entry ? 1 : 0;
    }
    if (found == table.size()) return listNode(std::move(elements), place);
  }
  return std::nullopt;
}

std::optional<Node> quaternionIn(const Node::Table& table, const Place& place) {
  std::vector<Node> elements;
  for (const std::string_view name : {"w", "x", "y", "z"}) {
    const Node* entry = entryNamed(table, {name});
    if (!entry || !numberIn(*entry)) return std::nullopt;
    elements.push_back(*entry);
  }
  return listNode(std::move(elements), place);
}

/// Returns the three rows of a tensor from a table with elements such as ixx, ixy and izz.
std::optional<Node> tensorIn(const Node::Table& table, const Place& place) {
  std::vector<Node> rows;
  std::size_t moments = 0;
  for (const char row : {'x', 'y', 'z'}) {
    std::vector<Node> elements;
    for (const char column : {'x', 'y', 'z'}) {
      const std::string name{row, column}, mirrored{column, row};
      const Node* entry = nullptr;
      for (const Entry& one : table) {
        const std::string key = core::lowered(one.key);
        if (key.size() <= 4 && (key.ends_with(name) || key.ends_with(mirrored))) entry = &one.value;
      }
      moments += entry && row == column ? 1 : 0;
      elements.push_back(entry ? *entry : zeroAt(place));
    }
    rows.push_back(listNode(std::move(elements), place));
  }
  return moments == 3 ? std::optional(listNode(std::move(rows), place)) : std::nullopt;
}

/// Returns two integers for a text such as "1920x1080", and for the names of usual sizes.
std::optional<Node> sidesIn(const Node& given) {
  const auto* text = given.as<std::string>();
  using Sides = std::pair<std::string_view, std::array<std::int64_t, 2>>;
  for (const auto& [name, sides] :
       {Sides{"480p", {854, 480}}, Sides{"720p", {1280, 720}}, Sides{"1080p", {1920, 1080}},
        Sides{"hd", {1920, 1080}}, Sides{"full_hd", {1920, 1080}}, Sides{"1440p", {2560, 1440}},
        Sides{"4k", {3840, 2160}}, Sides{"uhd", {3840, 2160}}, Sides{"2160p", {3840, 2160}}})
    if (text && plainWord(*text) == name)
      return listNode({Node{sides[0], given.place}, Node{sides[1], given.place}}, given.place);
  const std::size_t cross = text ? text->find_first_of("x*X,:") : std::string::npos;
  if (cross == std::string::npos) return std::nullopt;
  std::vector<Node> sides;
  for (const std::string_view part :
       {std::string_view(*text).substr(0, cross), std::string_view(*text).substr(cross + 1)}) {
    const auto side = plainNumber(part);
    if (!side) return std::nullopt;
    sides.push_back(numberAt(*side, given.place));
  }
  return listNode(std::move(sides), given.place);
}

/// Returns even whole numbers for the sides of a picture.
std::optional<Node> evenSides(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array) return std::nullopt;
  std::vector<Node> sides;
  for (const Node& side : *array) {
    const auto number = numberIn(side);
    if (!number || !(std::abs(*number) < 1e9)) return std::nullopt;
    sides.push_back({2 * static_cast<std::int64_t>(std::round(*number / 2)), given.place});
  }
  return listNode(std::move(sides), given.place);
}

/// Returns the magnitude of a vector with a single component that is not zero: 9.81 for gravity [0, 0, -9.81].
std::optional<Node> onlyComponent(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array) return std::nullopt;
  double only = 0;
  for (const Node& element : *array) {
    const auto number = numberIn(element);
    if (!number || (only != 0 && *number != 0)) return std::nullopt;
    if (*number != 0) only = std::abs(*number);
  }
  return Node{only, given.place};
}

/// Returns the number of an axis: "3" for "z", "e3", "axis 3" and [0, 0, 1].
std::optional<Node> axisIn(const Node& given) {
  if (const auto* array = given.as<Node::Array>()) {
    std::optional<Node> axis;
    for (std::size_t i = 0; i < array->size() && array->size() == 3; ++i)
      if (const auto number = numberIn((*array)[i]); !number)
        return std::nullopt;
      else if (*number != 0) {
        if (axis) return std::nullopt;
        axis = Node{fmt::format("{}", i + 1), given.place};
      }
    return axis;
  }
  const auto* text = given.as<std::string>();
  if (!text || text->empty() || text->size() > 20) return std::nullopt;
  const char last = plainWord(*text).back();
  for (const std::string_view letters : {"x1i", "y2j", "z3k"})
    if (letters.find(last) != std::string_view::npos) return Node{std::string(1, letters[1]), given.place};
  return std::nullopt;
}

bool isWordOf(const Key& key, std::string_view word) {
  return std::ranges::find(key.words, word) != key.words.end();
}

/// Returns a quantity or another word of a key for a word of other programs: "E" for "total energy", "T" for
/// "T(t)". Empty if the key has no such word.
std::string wordFor(const Key& key, std::string_view given) {
  std::string text(core::trimmed(given.substr(0, given.find('('))));
  if (isWordOf(key, text)) return text;
  const std::string plain = plainWord(text);
  if (isWordOf(key, plain)) return plain;
  for (const std::string_view other : wordsElsewhere(plain))
    if (isWordOf(key, other)) return std::string(other);
  if (const auto quantity = quantityElsewhere(plain); isWordOf(key, quantity)) return std::string(quantity);
  for (const std::string_view word : key.words)  // "4179 Toutatis", "the Earth"
    if (word.size() > 3 && plain.find(word) != std::string::npos) return std::string(word);
  if (key.path == "body.catalogue" && plain.size() > 3)
    if (const auto near = core::closest(plain, {key.words.begin(), key.words.end()})) return *near;
  for (const std::string_view part : {plain.substr(0, plain.find('_')), plain.substr(plain.rfind('_') + 1)})
    for (const std::string_view other : wordsElsewhere(part))
      if (part.size() > 2 && isWordOf(key, other)) return std::string(other);
  return "";
}

/// Returns a word in the spelling of this program: "box" for "cuboid".
std::optional<Node> inOurWords(const Key& key, const Node& given) {
  const auto* text = given.as<std::string>();
  const std::string word = text && text->size() <= kLongestText ? wordFor(key, *text) : "";
  return word.empty() ? std::nullopt : std::optional(Node{word, given.place});
}

std::optional<Node> severalWords(const Key& key, const Node& given) {
  std::vector<Node> words;
  const auto* array = given.as<Node::Array>();
  for (const Node& one : array ? *array : Node::Array{given}) {
    const auto word = inOurWords(key, one);
    if (!word) return std::nullopt;
    if (std::ranges::none_of(words,
                             [&](const Node& w) { return *w.as<std::string>() == *word->as<std::string>(); }))
      words.push_back(*word);
  }
  return listNode(std::move(words), given.place);
}

/// Returns a colour for its name, and for three parts from 0 to 1 or from 0 to 255.
std::optional<Node> colorIn(const Node& given) {
  if (const auto* text = given.as<std::string>()) {
    std::string name = plainWord(*text);
    if (const auto color = namedColor(name); !color.empty()) return Node{std::string(color), given.place};
    if (name.starts_with("#") && name.size() == 9) return Node{name.substr(0, 7), given.place};  // with an opacity
    std::erase(name, '_');
    const auto color = namedColor(name);
    return color.empty() ? std::nullopt : std::optional(Node{std::string(color), given.place});
  }
  const auto* array = given.as<Node::Array>();
  if (!array || array->size() < 3 || array->size() > 4) return std::nullopt;
  std::array<double, 3> parts{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto part = numberIn((*array)[i]);
    if (!part || !(*part >= 0 && *part <= 255)) return std::nullopt;
    parts[i] = *part;
  }
  const double unit = std::ranges::max(parts) <= 1 ? 255 : 1;
  const auto byte = [&](std::size_t i) { return static_cast<int>(std::lround(unit * parts[i])); };
  return Node{fmt::format("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2)), given.place};
}

/// Returns true or false for "on", "yes", 1 and other values that switch a thing on or off.
Node flagIn(const Node& given) {
  const auto* text = given.as<std::string>();
  const std::string word = text ? plainWord(*text) : "";
  const bool off = numberIn(given) == 0.0 || word == "off" || word == "no" || word == "false" || word == "none" ||
                   word == "hidden" || word == "hide";
  return {!off, given.place};
}

/// Returns the seconds of a time such as "1:30".
std::optional<Node> clockTime(const Node& given) {
  const auto* text = given.as<std::string>();
  if (!text || text->find(':') == std::string::npos || text->size() > 20) return std::nullopt;
  double seconds = 0;
  std::string_view rest = *text;
  while (true) {
    const std::size_t colon = rest.find(':');
    const auto part = plainNumber(rest.substr(0, colon));
    if (!part || *part < 0) return std::nullopt;
    seconds = 60 * seconds + *part;
    if (colon == std::string_view::npos) return numberAt(seconds, given.place);
    rest.remove_prefix(colon + 1);
  }
}

/// Returns a single value for a table of a value and its unit, and for a text that is a number.
std::optional<Node> singleIn(const Node& given) {
  if (const auto* table = given.as<Node::Table>()) {
    const Node *value = entryNamed(*table, {"value", "magnitude"}), *unit = entryNamed(*table, {"unit", "units"});
    if (!value || !unit || !numberIn(*value) || !unit->as<std::string>()) return std::nullopt;
    return Node{fmt::format("{} {}", describe(*value), *unit->as<std::string>()), given.place};
  }
  if (const auto* array = given.as<Node::Array>(); array && array->size() == 1) return (*array)[0];
  const auto* text = given.as<std::string>();
  const auto number = text && text->size() <= kLongestText ? plainNumber(*text) : std::nullopt;
  return number ? std::optional(numberAt(*number, given.place)) : std::nullopt;
}

bool isSingle(ValueType type) { return type == ValueType::kNumber || type == ValueType::kInteger; }

bool isVector(ValueType type) {
  return type == ValueType::kVector || type == ValueType::kPerAxis || type == ValueType::kExtents;
}

/// Collects the forms of a value.
class Forms {
 public:
  Forms(const Key& key, const Node& given) : key_(key), given_(given), forms_{given} {}

  std::vector<Node> run() {
    const auto* table = given_.as<Node::Table>();
    if (isVector(key_.type)) vectors(table);
    if (key_.type == ValueType::kMatrix) {
      if (table) add(tensorIn(*table, given_.place));
      add(numbersIn(given_));
    }
    if (key_.type == ValueType::kQuaternion) {
      if (table) add(quaternionIn(*table, given_.place));
      add(numbersIn(given_));
    }
    if (isSingle(key_.type)) singles();
    if (key_.type == ValueType::kFrameRate) singles();
    if (key_.type == ValueType::kPair) add(numbersIn(given_));
    if (isVector(key_.type)) add(numbersWithUnit(given_, key_.dimension));
    if (isVector(key_.type) || isSingle(key_.type)) add(spelledOut(given_, key_.dimension));
    words();
    inDegrees();
    return std::move(forms_);
  }

 private:
  void add(std::optional<Node> form) {
    if (form) forms_.push_back(std::move(*form));
  }

  void vectors(const Node::Table* table) {
    if (table) add(threeIn(*table, given_.place));
    add(numbersIn(given_));
    if (key_.type != ValueType::kVector || !isScalar(given_)) return;
    const Node zero = zeroAt(given_.place);
    add(listNode({zero, zero, given_}, given_.place));
    add(listNode({given_, given_, given_}, given_.place));
  }

  void singles() {
    if (key_.dimension == Dimension::kAcceleration) add(onlyComponent(given_));
    add(singleIn(given_));
    if (key_.dimension == Dimension::kTime) add(clockTime(given_));
    const auto* text = given_.as<std::string>();
    if (!text || text->size() > kLongestText) return;
    const auto factor = key_.dimension == Dimension::kNone ? factorIn(*text) : std::nullopt;
    if (factor) add(numberAt(*factor, given_.place));
    const std::size_t end = text->find_first_not_of("0123456789.");
    if (key_.type != ValueType::kNumber && end != std::string::npos && end > 0)  // "30 fps"
      if (const auto number = plainNumber(text->substr(0, end))) add(numberAt(*number, given_.place));
    const auto density = key_.dimension == Dimension::kDensity ? densityOf(plainWord(*text)) : "";
    if (!density.empty()) add(numberAt(*plainNumber(density), given_.place));
  }

  void words() {
    if (key_.type == ValueType::kPixels) {
      const auto sides = sidesIn(given_);
      add(sides);
      add(evenSides(sides ? *sides : given_));
    }
    if (key_.type == ValueType::kColor) add(colorIn(given_));
    if (key_.type == ValueType::kBool) add(flagIn(given_));
    if (key_.type == ValueType::kWords) add(severalWords(key_, given_));
    if (key_.type == ValueType::kText && numberIn(given_)) add(Node{describe(given_), given_.place});
    if (key_.type == ValueType::kNumber && !key_.words.empty()) add(inOurWords(key_, given_));
    if (key_.type != ValueType::kWord) return;
    add(inOurWords(key_, given_));
    if (isWordOf(key_, "1") && isWordOf(key_, "3")) add(axisIn(given_));
  }

  void inDegrees() {
    if (key_.dimension != Dimension::kAngle) return;
    std::vector<Node> degrees;
    for (const Node& form : forms_)
      if (numberIn(form) || form.as<Node::Array>()) degrees.push_back(withUnit(form, "deg", key_.dimension));
    const bool first = areDegrees(forms_.size() > 1 && given_.as<Node::Table>() ? forms_[1] : given_);
    forms_.insert(first ? forms_.begin() : forms_.end(), degrees.begin(), degrees.end());
  }

  const Key& key_;
  const Node& given_;
  std::vector<Node> forms_;
};

}  // namespace

std::optional<double> numberIn(const Node& node) {
  if (const auto* integer = node.as<std::int64_t>()) return static_cast<double>(*integer);
  const auto* number = node.as<double>();
  return number ? std::optional(*number) : std::nullopt;
}

bool isScalar(const Node& node) { return numberIn(node) || node.as<std::string>(); }

Node zeroAt(const Place& place) { return {std::int64_t{0}, place}; }

Node listNode(std::vector<Node> elements, const Place& place) { return {Node::Array(std::move(elements)), place}; }

Node scaled(const Node& given, double factor) {
  if (factor == 1) return given;
  if (const auto* array = given.as<Node::Array>()) {
    std::vector<Node> elements;
    for (const Node& element : *array) elements.push_back(scaled(element, factor));
    return listNode(std::move(elements), given.place);
  }
  if (const auto number = numberIn(given)) return {factor * *number, given.place};
  const auto* text = given.as<std::string>();
  double number = 0;
  const char* end = text ? std::from_chars(text->data(), text->data() + text->size(), number).ptr : nullptr;
  if (!text || end == text->data()) return given;
  return {fmt::format("{:.6g}{}", factor * number, std::string_view(end, text->data() + text->size() - end)),
          given.place};
}

Node withUnit(const Node& given, std::string_view unit, Dimension dimension) {
  if (unit.empty() || parseQuantity(fmt::format("1 {}", unit), dimension).value == 1) return given;
  if (const auto* array = given.as<Node::Array>()) {
    std::vector<Node> elements;
    for (const Node& element : *array) elements.push_back(withUnit(element, unit, dimension));
    return listNode(std::move(elements), given.place);
  }
  return numberIn(given) ? Node{fmt::format("{} {}", describe(given), unit), given.place} : given;
}

/// Returns a text such as "3 x 2 x 1" with blanks in place of the crosses between numbers.
static std::string withoutCrosses(std::string text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == 'x' && std::string_view("0123456789 .").find(text[i - 1]) != std::string_view::npos &&
        std::string_view("0123456789 .").find(text[i + 1]) != std::string_view::npos)
      text[i] = ' ';
  return text;
}

std::optional<Node> numbersIn(const Node& given) {
  const auto* text = given.as<std::string>();
  if (!text || text->size() > kLongestText) return std::nullopt;
  std::vector<Node> rows(1, listNode({}, given.place));
  std::string word;
  for (const char c : withoutCrosses(*text) + " ") {
    const bool ends = c == ';' || c == '\n', separates = std::string_view(" \t,()[]").find(c) != std::string::npos;
    if (!ends && !separates) {
      word += c;
      continue;
    }
    if (!word.empty()) {
      const auto number = plainNumber(word);
      if (!number) return std::nullopt;
      std::get<Node::Array>(rows.back().value).push_back(numberAt(*number, given.place));
      word.clear();
    }
    if (ends) rows.push_back(listNode({}, given.place));
  }
  std::erase_if(rows, [](const Node& row) { return row.as<Node::Array>()->empty(); });
  if (rows.empty()) return std::nullopt;
  return rows.size() == 1 ? rows[0] : listNode(std::move(rows), given.place);
}

std::vector<double> numbersInToml(std::string_view text, Dimension dimension) {
  std::vector<double> numbers;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of("[], "), text.size()));
    if (text.empty()) return numbers;
    const bool quoted = text.front() == '"';
    const std::size_t end = std::min(quoted ? text.find('"', 1) : text.find_first_of("[], "), text.size());
    const std::string one(text.substr(quoted ? 1 : 0, quoted ? end - 1 : end));
    const auto number = plainNumber(one);
    const Quantity quantity = quoted ? parseQuantity(one, dimension) : Quantity{};
    if (quoted ? !quantity.ok() : !number) return {};
    numbers.push_back(quoted ? quantity.value : *number);
    text.remove_prefix(std::min(end + (quoted ? 1 : 0), text.size()));
  }
}

bool areDegrees(const Node& given) {
  constexpr double kTurn_rad = 6.3, kFewRadians = 4;
  const auto* array = given.as<Node::Array>();
  const Node::Array elements = array ? *array : Node::Array{given};
  bool whole = true, large = false, beyond = false;
  for (const Node& element : elements) {
    const auto number = numberIn(element);
    if (!number) return false;
    whole &= *number == std::round(*number);
    large |= std::abs(*number) >= kFewRadians;
    beyond |= std::abs(*number) > kTurn_rad;
  }
  return beyond || (whole && large);
}

std::vector<Node> formsOf(const Key& key, const Node& given) { return Forms(key, given).run(); }

}  // namespace poinsot::scene
