// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_file.h"

#include <fmt/format.h>

#include <deque>
#include <functional>
#include <set>

#include "core/file_error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "scene/assembly/assemble.h"
#include "scene/assembly/style_file.h"
#include "scene/document/document.h"
#include "scene/document/text_lines.h"
#include "scene/keys/check.h"
#include "scene/keys/value_advice.h"
#include "scene/motion/film_loop.h"
#include "scene/motion/film_pace.h"
#include "scene/sweep.h"

namespace poinsot::scene {
namespace {

[[noreturn]] void refuseFile(const std::filesystem::path& path, const core::Error& cause) {
  const bool tooLong = cause.kind() == core::ErrorKind::kLimit;
  throw core::FileError(
      cause.kind(),
      "cannot read the scene: " + cause.message() + (tooLong ? "; " + howToRaise(Limit::kSceneBytes) : ""), path,
      core::codeOf(cause), core::SourceLocation{core::printable(path.string())});
}

bool looksLikeToml(std::string_view value) {
  return !value.empty() && std::string_view("\"'[{").find(value[0]) != std::string_view::npos;
}

/// Parses the value of an override as TOML. A value that is not TOML, such as down or 3 rpm, becomes a string.
Node overrideValue(const Source& source, std::string_view value, const Limits& limits) {
  try {
    Node document = parseDocument(source, limits);
    auto& entries = std::get<Node::Table>(document.value);
    if (entries.size() == 1 && entries[0].key == "v") return std::move(entries[0].value);
  } catch (const SceneErrors&) {
    if (looksLikeToml(value)) throw;
  }
  return {std::string(value), {&source, 0, 0, 1}};
}

void addOverride(const std::string& text, std::deque<Source>& sources, Leaves& leaves, Problems& problems) {
  const std::size_t equals = text.find('=');
  const std::string key(core::trimmed(std::string_view(text).substr(0, equals)));
  const std::string value(equals == std::string::npos ? ""
                                                      : core::trimmed(std::string_view(text).substr(equals + 1)));
  Source& source = sources.emplace_back("-D " + text, "v = " + value);
  source.setWithoutLines();
  const Place place{&source, 0, 0, 1};
  if (equals == std::string::npos || key.empty()) return problems.add(place, "expected -D key.path=value");
  if (hasRange(text))
    return problems.add(place, key + ": expected one value; only sweep, preview and submit take ranges");
  try {
    addLeaf(key, place, overrideValue(source, value, leaves.limits), leaves, problems);
  } catch (const SceneErrors& errors) {
    problems.add(place, errors.problems().front().message);
  }
}

/// Returns the defaults of all keys as one TOML document. The parser then checks them like the values of a file.
std::string defaultsText() {
  std::string text;
  for (const Key& key : keys())
    if (!key.fallback.empty()) text += fmt::format("{} = {}\n", key.path, key.fallback);
  return text;
}

using Paths = std::set<std::string, std::less<>>;

/// Makes a hidden thing visible if the scene gives a key of its table, but not the key "visible".
void askFor(std::string_view path, const Leaves& leaves, Draft& draft) {
  const std::string_view table = path.substr(0, path.rfind('.'));
  const std::string visible = std::string(table) + ".visible";
  if (isExtra(table) && !leaves.values.contains(visible))
    findKey(visible)->put(draft, elementOf(visible), Checked(true));
}

/// Checks all values. Stores valid values in the draft and adds the paths of the others to `refused`.
Draft checkedDraft(Leaves& leaves, Draft draft, Paths& refused, Problems& problems) {
  for (const auto& [path, node] : leaves.values) {
    const Key& key = *findKey(path);
    if (const auto value = check(key, path, node, problems, leaves.limits)) {
      askFor(path, leaves, draft);
      key.put(draft, elementOf(path), *value);
    } else {
      refused.insert(path);
      problems.lastMessage() = withAdvice(problems.lastMessage(), path, node, leaves);
    }
  }
  return draft;
}

Draft defaultDraft() {
  const Source source("defaults", defaultsText());
  Leaves leaves;
  Paths refused;
  Problems problems;
  addLeaves(parseDocument(source), leaves, problems);
  Draft draft = checkedDraft(leaves, {}, refused, problems);
  problems.throwIfAny();
  return draft;
}

/// Checks the TeX in texts. Skips values that failed their own checks, so that one mistake yields one problem.
void checkTexts(const Leaves& leaves, const TextCheck& check, const Paths& refused, Problems& problems) {
  for (const auto& [path, node] : leaves.values) {
    if (!check || !findKey(path)->isTex || refused.contains(path)) continue;
    for (const Node& line : linesOf(node)) {
      const auto* text = line.as<std::string>();
      if (const std::string wrong = text ? check(*text) : ""; !wrong.empty())
        problems.add(line.place, fmt::format("{}: {}", path, wrong));
    }
  }
}

/// Checks that a frame does not show more characters than the limit allows. Counts all texts and the longest
/// caption, because a frame shows one caption at a time. Each text costs every worker a layout and every frame a
/// lookup.
void checkCharacters(const Leaves& leaves, Findings& findings) {
  std::size_t others = 0, caption = 0;
  for (const auto& [path, node] : leaves.values) {
    if (!findKey(path)->isTex) continue;
    std::size_t count = 0;
    for (const Node& line : linesOf(node))
      if (const auto* text = line.as<std::string>()) count += characterCount(*text);
    if (path.ends_with("].caption"))
      caption = std::max(caption, count);
    else
      others += count;
  }
  const std::int64_t most = leaves.limits[Limit::kCharacters];
  if (others + caption > static_cast<std::size_t>(most))
    findings.refuseFile(fmt::format("a frame may show at most {} characters, got {}; {}", most, others + caption,
                                    howToRaise(Limit::kCharacters)));
}

void closeIfAsked(Scene& scene, Findings& findings, const Limits& limits) {
  if (!scene.time.loop) return;
  try {
    closeLoop(scene, limits);
  } catch (const core::Error& error) {
    findings.refuse("time.loop", error.message());
  }
}

}  // namespace

Scene parseScene(std::string_view text, const std::string& fileName, const std::vector<std::string>& overrides,
                 const TextCheck& textCheck, const Allowance& allowance) {
  const Limits& limits = allowance.limits;
  std::deque<Source> sources;  // a deque does not move its elements, to which each Place points
  const Source& file = sources.emplace_back(fileName, std::string(text));
  Leaves leaves{.limits = limits};
  Problems problems;
  PartialDocument document = parseValidParts(file, limits, problems);
  leaves.broken = std::move(document.broken);
  addLeaves(document.root, leaves, problems);
  for (const std::string& word : overrides) addOverride(word, sources, leaves, problems);
  const std::filesystem::path path(fileName);
  const SceneFolder folder(path.parent_path(), allowance);
  addStyleFile(folder, sources, leaves, problems);
  static const Draft defaults = defaultDraft();
  Paths refused;
  Draft draft = checkedDraft(leaves, defaults, refused, problems);
  Findings findings(leaves, refused, {&file, 0, 0, 1}, problems);
  Scene scene = assemble(std::move(draft), findings, folder);
  checkTexts(leaves, textCheck, refused, problems);
  checkCharacters(leaves, findings);
  problems.throwIfAny();
  closeIfAsked(scene, findings, limits);  // only if the scene has no other problem
  problems.throwIfAny();
  scene.name = path.stem().string();
  scene.inputs = folder.filesRead();
  doubtValues(scene, leaves, findings);
  doubtPrecession(scene, findings);
  doubtForces(scene, findings);
  scene.doubts = findings.doubts();
  scene.motion.mostSteps = static_cast<double>(limits[Limit::kSteps]);
  return scene;
}

std::string readSceneText(const std::filesystem::path& path, const Limits& limits) {
  try {
    return core::allBytesOf(core::openForReading(path), limits.bytes(Limit::kSceneBytes), core::ErrorKind::kScene);
  } catch (const core::Error& error) {
    refuseFile(path, error);
  }
}

Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                const TextCheck& textCheck, const Allowance& allowance) {
  return parseScene(readSceneText(path, allowance.limits), path.string(), overrides, textCheck, allowance);
}

}  // namespace poinsot::scene
