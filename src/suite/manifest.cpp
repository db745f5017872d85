// SPDX-License-Identifier: Apache-2.0
#include "suite/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "core/error.h"
#include "core/expect.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "output/film_reader.h"
#include "scene/document/document.h"
#include "scene/limits.h"
#include "suite/files.h"
#include "suite/keys.h"
#include "suite/values.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;
using scene::Entry;
using scene::Node;

/// Callbacks that read the values of a table, by key. If a callback throws a core::Error, the error is reported
/// with the position of the value in the file.
using Takers = std::map<std::string, std::function<void(const Node&)>, std::less<>>;

/// Reports whether a text can name a test: a relative path without hidden parts, at most 200 bytes, all printable.
bool isName(const std::string& name) {
  constexpr std::size_t kLongest = 200;
  if (name.empty() || name.size() > kLongest || core::printable(name) != name) return false;
  const fs::path path = name;
  if (path.is_absolute() || path.filename().empty()) return false;
  return std::ranges::none_of(path, [](const fs::path& part) { return part.native().starts_with('.'); });
}

/// Replaces the star in a test's name by the name of a file. Normalises the path: `a//b` becomes `a/b`.
std::string filledIn(std::string pattern, const std::string& file) {
  if (const auto star = pattern.find('*'); star != std::string::npos) pattern.replace(star, 1, file);
  return isName(pattern) ? fs::path(pattern).lexically_normal().native() : pattern;
}

class Reader {
 public:
  Reader(const fs::path& file, std::string text, const scene::Allowance& allowance, const fs::path& images)
      : source_(file.native(), std::move(text)),
        folder_(file.parent_path()),
        images_(images.empty() ? folder_ : images),
        allowance_(allowance) {
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
          {"variant", [&](const Node& n) { usual.variant = textOf(n); }},
          {"rule", [&](const Node& n) { usual.rule = rule(n, "rule."); }},
          {"test", [&](const Node& n) { tests = tables(n); }}});
    for (const Node* test : tests) addTest(*test, usual);
    if (tests.empty() && problems_.empty())
      problems_.add({&source_, 1, 1}, "expected at least one [[test]], which names pictures to compare");
    problems_.throwIfAny();
    return std::move(manifest_);
  }

 private:
  bool isAllowed(const fs::path& path) const {
    const auto holds = [&](const fs::path& folder) { return isBeneath(path, folder); };
    return holds(folder_) || std::ranges::any_of(allowance_.assetRoots, holds);
  }

  bool mayBeRead(const fs::path& path) const {
    return isAllowed(path) || isBeneath(path, images_) || isBeneath(path, ".");
  }

  /// Returns the folder of references, after checking that --update may write to it.
  fs::path written(const Node& node) const {
    fs::path path = folder_ / textOf(node);
    if (!isAllowed(path))
      refuseValue(fmt::format("{} is not below the folder of this file; --asset-root FOLDER allows another",
                              describe(node)));
    return path;
  }

  /// Returns a path or pattern, relative to `folder`, after checking that its fixed folder may be read.
  std::string readable(const Node& node, const fs::path& folder) const {
    const std::string& path = textOf(node);
    if (!mayBeRead(fixedFolder(folder, path))) refuseOutside(describe(node));
    return path;
  }

  fs::path readableFile(const Node& node) const {
    fs::path file = folder_ / textOf(node);
    if (!mayBeRead(file)) refuseOutside(describe(node));
    return file;
  }

  [[noreturn]] static void refuseOutside(const std::string& what) {
    refuseValue(
        fmt::format("{} is neither below the folder of this file nor below the current one; --asset-root FOLDER "
                    "allows another",
                    what));
  }

  static std::string tableOf(std::string_view prefix) {
    if (prefix.empty()) return "";
    prefix.remove_suffix(1);
    return std::string(prefix.substr(prefix.find('.') == std::string_view::npos ? 0 : prefix.find('.') + 1));
  }

  static std::vector<const Node*> tables(const Node& node) {
    const auto* array = node.as<Node::Array>();
    if (!array) refuseValue("expected [[test]] tables, each with its own heading");
    std::vector<const Node*> tables;
    for (const Node& one : *array) tables.push_back(&one);
    return tables;
  }

  void takeHeight(const Node& node, GoldenTest& test) const {
    test.height = sideOf(node, allowance_.limits);
    test.heightAt = locationOf(node.place);
  }

  void take(const Node& node, const std::string& prefix, const Takers& takers) {
    POINSOT_EXPECT(std::ranges::equal(goldenKeysOf(tableOf(prefix)), takers, {}, {}, &Takers::value_type::first));
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

  compare::PictureRule rule(const Node& node, const std::string& prefix) {
    compare::PictureRule rule;
    if (node.as<std::string>()) {
      rule.limits = compare::namedLimits("rule", textOf(node));
      return rule;
    }
    Takers takers = {{"like", [&](const Node& n) { rule.limits = compare::namedLimits("a rule", textOf(n)); }},
                     {"ignore", [&](const Node& n) { rule.ignore = boxesOf(n); }},
                     {"mask", [&](const Node& n) { rule.mask = readableFile(n); }},
                     {"reason", [&](const Node& n) { rule.reason = textOf(n); }}};
    // Limits are stored here and applied after "like", because "like" sets all limits and may be a later key of
    // the table.
    std::map<std::string_view, std::string> words;
    for (const compare::RuleLimit& limit : compare::ruleLimits())
      takers[limit.key] = [&words, &limit](const Node& n) {
        compare::NearRule tried;
        limit.set(tried, "a limit", words[limit.key] = wordOf(n));
      };
    const std::size_t problems = problems_.size();
    take(node, prefix, takers);
    if (!node.as<Node::Table>() || problems_.size() > problems) return rule;
    for (const compare::RuleLimit& limit : compare::ruleLimits())
      if (words.contains(limit.key)) limit.set(rule.limits, limit.key, words[limit.key]);
    compare::expectCanRefuse(rule.limits, "the limits");
    if (rule.reason.empty()) refuseValue("expected the key reason beside the limits: why the picture may differ");
    return rule;
  }

  void addTest(const Node& node, const GoldenTest& usual) {
    GoldenTest test = usual;
    std::string scene, image;
    bool hasSize = false;
    const std::size_t problems = problems_.size();
    take(node, "test.",
         {{"name", [&](const Node& n) { test.name = textOf(n); }},
          {"scene", [&](const Node& n) { scene = readable(n, folder_); }},
          {"image", [&](const Node& n) { image = readable(n, images_); }},
          {"times",
           [&](const Node& n) {
             test.times_s = listOf(n, timeOf);
             test.timesAt = locationOf(n.place);
           }},
          {"size",
           [&](const Node& n) {
             test.size = sizeOf(n, allowance_.limits);
             hasSize = true;
           }},
          {"height",
           [&](const Node& n) {
             takeHeight(n, test);
             test.size.reset();
             hasSize = true;
           }},
          {"set", [&](const Node& n) { test.overrides = listOf(n, textOf); }},
          {"variant", [&](const Node& n) { test.variant = textOf(n); }},
          {"rule", [&](const Node& n) { test.rule = rule(n, "test.rule."); }}});
    if (problems_.size() > problems) return;  // any further errors would follow from these
    if (scene.empty() == image.empty()) return problems_.add(node.place, "test: expected either scene or image");
    if (!image.empty() && (!test.times_s.empty() || !test.overrides.empty()))
      return problems_.add(node.place, "test: the keys `times` and `set` are allowed only beside `scene`");
    if (!image.empty() && hasSize)
      return problems_.add(
          node.place,
          "test: the keys `size` and `height` are allowed only beside `scene`; an image has its own size");
    if (!scene.empty() && !test.variant.empty() && test.variant != usual.variant)
      return problems_.add(node.place,
                           "test: variant is allowed with image only; a scene's variant is its renderer");
    addFiles(scene.empty() ? image : scene, scene.empty() ? &GoldenTest::image : &GoldenTest::scene, test, node);
  }

  void addFiles(const std::string& path, fs::path GoldenTest::*place, GoldenTest test, const Node& node) {
    const bool isImage = place == &GoldenTest::image;
    const char* key = isImage ? "test.image" : "test.scene";
    const fs::path& folder = isImage ? images_ : folder_;
    test.file = path;
    test.folder = folder;
    test.at = locationOf(node.place);
    if (test.name.empty()) test.name = "*";
    test.namePattern = test.name;
    if (!isName(filledIn(test.name, "x"))) return refuseName(test.name, node);  // even if no file matches
    std::vector<MatchedFile> files = filesMatching(folder, path);
    if (isImage && isPattern(path))
      std::erase_if(files, [](const auto& f) { return !output::isPictureOrFilmName(f.file); });
    if (files.empty() && isImage) return addUnmatched(std::move(test), folder / path);
    if (files.empty())
      return problems_.add(node.place, fmt::format("{}: no file matches {}", key, core::printable(path)));
    for (const auto& [file, name] : files) {
      test.*place = file;
      if (mayBeRead(file))
        add(test, name, node);
      else
        problems_.add(node.place, fmt::format("{}: {} is a link to a place outside of the allowed folders", key,
                                              core::printable(file.native())));
    }
  }

  /// Adds a pattern of images that matches no file. The manifest is valid; the run reports the error in its
  /// results.
  void addUnmatched(GoldenTest test, const fs::path& pattern) {
    test.name = core::printable(test.file);
    test.image = pattern;
    test.isUnmatched = true;
    manifest_.tests.push_back(std::move(test));
  }

  void refuseName(const std::string& name, const Node& node) {
    problems_.add(
        node.place,
        fmt::format("test.name: '{}': must be a relative path of at most 200 printable characters, in which "
                    "no part begins with a dot",
                    core::printable(name)));
  }

  static std::string lineOf(const GoldenTest& test) {
    return fmt::format("line {}{}", test.at.line, matchedText(test, ", of "));
  }

  /// Adds a test. @param file name that replaces the * in the test's name
  void add(GoldenTest test, const std::string& file, const Node& node) {
    test.name = filledIn(test.name, file);
    if (!isName(test.name)) return refuseName(test.name, node);
    const auto [first, isNew] = names_.try_emplace(test.name, lineOf(test));
    if (!isNew)
      return problems_.add(
          node.place, fmt::format("test.name: {}{} is already the name of the test in {}; choose another name",
                                  test.name, matchedText(test, " of "), first->second));
    manifest_.tests.push_back(std::move(test));
  }

  scene::Source source_;
  fs::path folder_, images_;
  const scene::Allowance& allowance_;
  scene::Problems problems_;
  GoldenManifest manifest_;
  std::map<std::string, std::string> names_;  ///< position of each test's [[test]] table, by the test's name
};

}  // namespace

std::string matchedText(const GoldenTest& test, std::string_view before) {
  const fs::path& file = test.scene.empty() ? test.image : test.scene;
  return isPattern(test.file) ? fmt::format("{}{}", before, core::printable(file.native())) : "";
}

GoldenManifest parseGoldenManifest(std::string text, const fs::path& file, const scene::Allowance& allowance,
                                   const fs::path& images) {
  return Reader(file, std::move(text), allowance, images).read();
}

GoldenManifest readGoldenManifest(const fs::path& file, const scene::Allowance& allowance,
                                  const fs::path& images) {
  const std::size_t most = allowance.limits.bytes(scene::Limit::kSceneBytes);
  return parseGoldenManifest(core::readRegularFile(file, most, core::ErrorKind::kIo), file, allowance, images);
}

}  // namespace poinsot::suite
