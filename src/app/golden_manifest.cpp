// SPDX-License-Identifier: Apache-2.0
#include "app/golden_manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <system_error>

#include "core/error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "scene/document.h"
#include "scene/limits.h"
#include "scene/units.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;
using scene::Entry;
using scene::Node;

/// What a key may be, and what takes its value. A taker that throws core::Error has its message said at the value.
using Takers = std::map<std::string, std::function<void(const Node&)>, std::less<>>;

[[noreturn]] void refuse(const std::string& message) { throw core::Error(core::ErrorKind::kScene, message); }

const std::string& textOf(const Node& node) {
  const auto* text = node.as<std::string>();
  if (!text || text->empty()) refuse(fmt::format("expected a text, got {}", describe(node)));
  return *text;
}

int sideOf(const Node& node, const scene::Limits& limits) {
  const auto* side = node.as<std::int64_t>();
  const std::int64_t most = limits[scene::Limit::kSide];
  if (!side || *side < scene::kLeastSide || *side > most)
    refuse(fmt::format("expected pixels from {} to {}, got {}{}", scene::kLeastSide, most, describe(node),
                       side && *side > most ? "; " + howToRaise(scene::Limit::kSide) : ""));
  return static_cast<int>(*side);
}

image::PixelSize sizeOf(const Node& node, const scene::Limits& limits) {
  const auto* sides = node.as<Node::Array>();
  if (!sides || sides->size() != 2) refuse(fmt::format("expected [width, height], got {}", describe(node)));
  return {sideOf((*sides)[0], limits), sideOf((*sides)[1], limits)};
}

/// Without links; of what is not there, as far as it is.
fs::path real(const fs::path& path) {
  std::error_code failure;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, failure), failure);
  if (failure) return {};
  return whole.has_filename() ? whole : whole.parent_path();
}

bool isBeneath(const fs::path& path, const fs::path& folder) {
  const fs::path inner = real(path), outer = real(folder);
  return !inner.empty() && !outer.empty() && std::ranges::mismatch(outer, inner).in1 == outer.end();
}

double timeOf(const Node& node) {
  const auto* whole = node.as<std::int64_t>();
  const auto* number = node.as<double>();
  double t_s = whole ? static_cast<double>(*whole) : number ? *number : -1;
  if (const auto* text = node.as<std::string>()) {
    const auto quantity = scene::parseQuantity(*text, scene::Dimension::kTime);
    t_s = quantity.ok() ? quantity.value : -1;
  }
  if (!(t_s >= 0)) refuse(fmt::format("expected a film time such as 1.5 or \"90 ms\", got {}", describe(node)));
  return t_s;
}

/// One or a list of them.
template <class F>
auto listOf(const Node& node, F element) {
  std::vector<std::decay_t<decltype(element(node))>> list;
  if (const auto* nodes = node.as<Node::Array>())
    for (const Node& one : *nodes) list.push_back(element(one));
  else
    list.push_back(element(node));
  if (list.empty()) refuse("expected at least one");
  return list;
}

bool isName(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  };
  return !name.empty() && name.size() <= 100 && name.front() != '.' && std::ranges::all_of(name, plain);
}

/// A text, or a number as it would be written in one.
std::string wordOf(const Node& node) {
  if (const auto* whole = node.as<std::int64_t>()) return fmt::format("{}", *whole);
  if (const auto* number = node.as<double>()) return fmt::format("{}", *number);
  return textOf(node);
}

double numberOf(const Node& node) {
  const auto* whole = node.as<std::int64_t>();
  if (!whole) refuse(fmt::format("expected a whole number of pixels, got {}", describe(node)));
  return static_cast<double>(*whole);
}

/// [x, y, width, height], or a list of such.
std::vector<image::PixelRect> boxesOf(const Node& node) {
  const auto* list = node.as<Node::Array>();
  if (!list || list->empty()) refuse(fmt::format("expected [[x, y, width, height], ...], got {}", describe(node)));
  if (!list->front().as<Node::Array>()) return {ignoredBox(describe(node), listOf(node, numberOf))};
  return listOf(node, [](const Node& n) { return ignoredBox(describe(n), listOf(n, numberOf)); });
}

/// Reads one manifest; all that is wrong is gathered.
class Reader {
 public:
  Reader(const fs::path& file, std::string text, const scene::Allowance& allowance)
      : source_(file.native(), std::move(text)), folder_(file.parent_path()), allowance_(allowance) {
    manifest_.file = file;
    manifest_.references = folder_ / "golden";
  }

  GoldenManifest read() {
    const Node document = scene::parseDocument(source_, allowance_.limits);
    GoldenTest usual;
    std::vector<const Node*> tests;
    take(document, "",
         {{"references", [&](const Node& n) { manifest_.references = written(n); }},
          {"size", [&](const Node& n) { usual.size = sizeOf(n, allowance_.limits); }},
          {"height", [&](const Node& n) { takeHeight(n, usual); }},
          {"rule", [&](const Node& n) { usual.rule = rule(n, "rule."); }},
          {"test", [&](const Node& n) { tests = tables(n); }}});
    for (const Node* test : tests) addTest(*test, usual);
    if (tests.empty() && problems_.empty())
      problems_.add({&source_, 1, 1}, "expected [[test]], the pictures to compare");
    problems_.throwIfAny();
    return std::move(manifest_);
  }

 private:
  bool isAllowed(const fs::path& path) const {
    const auto holds = [&](const fs::path& folder) { return isBeneath(path, folder); };
    return holds(folder_) || std::ranges::any_of(allowance_.assetRoots, holds);
  }

  bool mayBeRead(const fs::path& path) const { return isAllowed(path) || isBeneath(path, "."); }

  /// The folder of references, into which --update writes.
  fs::path written(const Node& node) const {
    fs::path path = folder_ / textOf(node);
    if (!isAllowed(path))
      refuse(fmt::format("{} is not below the folder of this file; --asset-root FOLDER allows another",
                         describe(node)));
    return path;
  }

  fs::path read(const Node& node) const {
    fs::path path = folder_ / textOf(node);
    if (!mayBeRead(path)) refuseOutside(describe(node));
    return path;
  }

  [[noreturn]] static void refuseOutside(const std::string& what) {
    refuse(
        fmt::format("{} is neither below the folder of this file nor below the current one; --asset-root FOLDER "
                    "allows another",
                    what));
  }

  static std::vector<const Node*> tables(const Node& node) {
    const auto* array = node.as<Node::Array>();
    if (!array) refuse("expected [[test]], each with a heading of its own");
    std::vector<const Node*> tables;
    for (const Node& one : *array) tables.push_back(&one);
    return tables;
  }

  void takeHeight(const Node& node, GoldenTest& test) const {
    test.height = sideOf(node, allowance_.limits);
    test.heightAt = locationOf(node.place);
  }

  void take(const Node& node, const std::string& prefix, const Takers& takers) {
    const auto* table = node.as<Node::Table>();
    if (!table)
      return problems_.add(node.place, fmt::format("{}: expected a table, got {}",
                                                   prefix.substr(0, prefix.rfind('.')), describe(node)));
    for (const Entry& entry : *table) {
      const auto taker = takers.find(entry.key);
      if (taker == takers.end()) {
        std::vector<std::string> names;
        for (const auto& known : takers) names.push_back(known.first);
        const auto near = core::closest(entry.key, names);
        problems_.add(entry.keyPlace, fmt::format("{}{}: unknown key{}", prefix, core::printable(entry.key),
                                                  near ? fmt::format("; did you mean {}{}?", prefix, *near) : ""));
        continue;
      }
      try {
        taker->second(entry.value);
      } catch (const core::Error& error) {
        problems_.add(entry.value.place, fmt::format("{}{}: {}", prefix, entry.key, error.message()));
      }
    }
  }

  /// A rule by its name, or a table of limits with the reason for them.
  PictureRule rule(const Node& node, const std::string& prefix) {
    PictureRule rule;
    if (node.as<std::string>()) {
      rule.limits = namedLimits("rule", textOf(node));
      return rule;
    }
    Takers takers = {{"like", [&](const Node& n) { rule.limits = namedLimits("a rule", textOf(n)); }},
                     {"ignore", [&](const Node& n) { rule.ignore = boxesOf(n); }},
                     {"mask", [&](const Node& n) { rule.mask = read(n); }},
                     {"reason", [&](const Node& n) { rule.reason = textOf(n); }}};
    // After "like", which sets all limits, wherever it stands in the table.
    std::map<std::string_view, std::string> words;
    for (const RuleLimit& limit : ruleLimits())
      takers[limit.key] = [&words, &limit](const Node& n) {
        image::NearRule tried;
        limit.set(tried, "a limit", words[limit.key] = wordOf(n));
      };
    const std::size_t problems = problems_.size();
    take(node, prefix, takers);
    if (!node.as<Node::Table>() || problems_.size() > problems) return rule;
    for (const RuleLimit& limit : ruleLimits())
      if (words.contains(limit.key)) limit.set(rule.limits, limit.key, words[limit.key]);
    expectCanRefuse(rule.limits, "the limits");
    if (rule.reason.empty()) refuse("expected a reason beside the limits: why may this picture differ?");
    return rule;
  }

  void addTest(const Node& node, const GoldenTest& usual) {
    GoldenTest test = usual;
    std::string scene;
    take(node, "test.",
         {{"name", [&](const Node& n) { test.name = textOf(n); }},
          {"scene",
           [&](const Node& n) {
             scene = textOf(n);
             if (!mayBeRead((folder_ / scene).parent_path())) refuseOutside(describe(n));
           }},
          {"image", [&](const Node& n) { test.image = read(n); }},
          {"times",
           [&](const Node& n) {
             test.times_s = listOf(n, timeOf);
             test.timesAt = locationOf(n.place);
           }},
          {"size", [&](const Node& n) { test.size = sizeOf(n, allowance_.limits); }},
          {"height",
           [&](const Node& n) {
             takeHeight(n, test);
             test.size.reset();
           }},
          {"set", [&](const Node& n) { test.overrides = listOf(n, textOf); }},
          {"rule", [&](const Node& n) { test.rule = rule(n, "test.rule."); }}});
    if (scene.empty() == test.image.empty())
      return problems_.add(node.place, "test: expected a scene or an image, one of the two");
    if (!test.image.empty() && (!test.times_s.empty() || !test.overrides.empty()))
      return problems_.add(node.place, "test: times and set are for a scene");
    if (const fs::path name = test.image.stem(); scene.empty()) return add(std::move(test), name, node);
    const auto files = filesOf(scene);
    if (files.empty())
      return problems_.add(node.place,
                           fmt::format("test.scene: no file is there of the name {}", core::printable(scene)));
    for (const fs::path& file : files) {
      test.scene = file;
      if (mayBeRead(file))
        add(test, file.stem(), node);
      else
        problems_.add(node.place,
                      fmt::format("test.scene: {} is a link that leads out of the folders that are allowed",
                                  core::printable(file.native())));
    }
  }

  /// The files that a name with at most one * in its last part means; that itself where it has none.
  std::vector<fs::path> filesOf(const std::string& word) const {
    const fs::path pattern = folder_ / word;
    const std::string name = pattern.filename();
    const auto star = name.find('*');
    if (star == std::string::npos) return {pattern};
    const std::string head = name.substr(0, star), tail = name.substr(star + 1);
    std::vector<fs::path> files;
    std::error_code ignored;  // no folder has no files
    const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      const std::string there = entry.path().filename();
      if (there.size() >= head.size() + tail.size() && there.starts_with(head) && there.ends_with(tail))
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
  }

  /// `stem` stands for the * of a test's name, or is the name.
  void add(GoldenTest test, const std::string& stem, const Node& node) {
    if (test.name.empty()) test.name = "*";
    if (const auto star = test.name.find('*'); star != std::string::npos) test.name.replace(star, 1, stem);
    if (!isName(test.name))
      return problems_.add(node.place,
                           fmt::format("test.name: '{}': letters, digits, _ - and . make a name, which "
                                       "names a file",
                                       core::printable(test.name)));
    if (!names_.insert(test.name).second)
      return problems_.add(node.place, fmt::format("test.name: {} is the name of another test", test.name));
    manifest_.tests.push_back(std::move(test));
  }

  scene::Source source_;
  fs::path folder_;
  const scene::Allowance& allowance_;
  scene::Problems problems_;
  GoldenManifest manifest_;
  std::set<std::string> names_;
};

}  // namespace

GoldenManifest parseGoldenManifest(std::string text, const fs::path& file, const scene::Allowance& allowance) {
  return Reader(file, std::move(text), allowance).read();
}

GoldenManifest readGoldenManifest(const fs::path& file, const scene::Allowance& allowance) {
  const std::size_t most = allowance.limits.bytes(scene::Limit::kSceneBytes);
  return parseGoldenManifest(core::readRegularFile(file, most, core::ErrorKind::kIo), file, allowance);
}

}  // namespace poinsot::app
