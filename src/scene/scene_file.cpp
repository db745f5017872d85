// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <deque>

#include "core/text.h"
#include "scene/assemble.h"
#include "scene/check.h"
#include "scene/document.h"

namespace poinsot::scene {
namespace {

// --- Reading the file ---

[[noreturn]] void refuseFile(const std::filesystem::path& path, const std::string& why) {
  throw core::Error(core::ErrorKind::kScene,
                    fmt::format("cannot read the scene {}: {}", core::printable(path.string()), why));
}

/// Closes on every way out.
class File {
 public:
  // O_NONBLOCK: opening a FIFO must not wait for its writer.
  explicit File(const std::filesystem::path& path)
      : handle_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (handle_ < 0) refuseFile(path, std::strerror(errno));
  }
  ~File() { ::close(handle_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  int handle() const { return handle_; }

 private:
  int handle_;
};

void expectRegular(const File& file, const std::filesystem::path& path) {
  struct stat status {};
  if (::fstat(file.handle(), &status) != 0) refuseFile(path, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) refuseFile(path, "it is a directory");
  if (!S_ISREG(status.st_mode)) refuseFile(path, "it is not a regular file");
}

/// At most one byte more than a scene may have, which is enough to refuse it.
std::string textOf(const std::filesystem::path& path) {
  const File file(path);
  expectRegular(file, path);
  std::string text;
  char buffer[1 << 16];
  while (text.size() <= kMostBytes) {
    const ssize_t count = ::read(file.handle(), buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuseFile(path, std::strerror(errno));
    if (count == 0) break;
    text.append(buffer, static_cast<std::size_t>(count));
  }
  return text;
}

// --- Overrides ---

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

bool looksLikeToml(std::string_view value) {
  return !value.empty() && std::string_view("\"'[{").find(value[0]) != std::string_view::npos;
}

/// The text after "=" as a TOML value; a bare word (down, 3 rpm) is text.
Node overrideValue(const Source& source, std::string_view value) {
  try {
    Node document = parseDocument(source);
    auto& entries = std::get<Node::Table>(document.value);
    if (entries.size() == 1 && entries[0].key == "v") return std::move(entries[0].value);
  } catch (const SceneErrors&) {
    if (looksLikeToml(value)) throw;
  }
  return {std::string(value), {&source, 0, 0, 1}};
}

void addOverride(const std::string& text, std::deque<Source>& sources, Leaves& leaves, Problems& problems) {
  const std::size_t equals = text.find('=');
  const std::string key(trimmed(std::string_view(text).substr(0, equals)));
  const std::string value(equals == std::string::npos ? "" : trimmed(std::string_view(text).substr(equals + 1)));
  Source& source = sources.emplace_back("-D " + text, "v = " + value);
  source.setWithoutLines();
  const Place place{&source, 0, 0, 1};
  if (equals == std::string::npos || key.empty()) return problems.add(place, "expected -D key.path=value");
  try {
    addLeaf(key, place, overrideValue(source, value), leaves, problems);
  } catch (const SceneErrors& errors) {
    problems.add(place, errors.problems().front().message);
  }
}

// --- From values to a scene ---

/// All defaults as one document: they are read, checked and put by the same route as a file.
std::string defaultsText() {
  std::string text;
  for (const Key& key : keys())
    if (!key.fallback.empty()) text += fmt::format("{} = {}\n", key.path, key.fallback);
  return text;
}

Draft checkedDraft(const Leaves& leaves, Draft draft, Problems& problems) {
  for (const auto& [path, node] : leaves) {
    const Key& key = *findKey(path);
    if (const auto value = check(key, node, problems)) key.put(draft, *value);
  }
  return draft;
}

Draft defaultDraft() {
  const Source source("defaults", defaultsText());
  Leaves leaves;
  Problems problems;
  addLeaves(parseDocument(source), leaves, problems);
  Draft draft = checkedDraft(leaves, {}, problems);
  problems.throwIfAny();
  return draft;
}

Place keyPlace(const Node& document, std::string_view key, const Place& otherwise) {
  for (const Entry& entry : std::get<Node::Table>(document.value))
    if (entry.key == key) return entry.keyPlace;
  return otherwise;
}

Origins originsIn(const Node& document, const Source& file) {
  const Place start{&file, 0, 0, 1};
  return {start, keyPlace(document, "body", start), keyPlace(document, "motion", start)};
}

void checkTexts(const Leaves& leaves, const TextCheck& check, Problems& problems) {
  for (const char* path : {"show.title", "show.subtitle"}) {
    const auto leaf = leaves.find(path);
    const auto* text = leaf == leaves.end() ? nullptr : leaf->second.as<std::string>();
    if (const std::string wrong = text && check ? check(*text) : ""; !wrong.empty())
      problems.add(leaf->second.place, fmt::format("{}: {}", path, wrong));
  }
}

}  // namespace

Scene parseScene(std::string_view text, const std::string& fileName, const std::vector<std::string>& overrides,
                 const TextCheck& textCheck) {
  std::deque<Source> sources;  // places point into it; a deque never moves what it holds
  const Source& file = sources.emplace_back(fileName, std::string(text));
  Leaves leaves;
  Problems problems;
  const Node document = parseDocument(file);
  addLeaves(document, leaves, problems);
  for (const std::string& word : overrides) addOverride(word, sources, leaves, problems);
  static const Draft defaults = defaultDraft();
  Scene scene = assemble(checkedDraft(leaves, defaults, problems), leaves, originsIn(document, file), problems);
  checkTexts(leaves, textCheck, problems);
  problems.throwIfAny();
  scene.name = std::filesystem::path(fileName).stem().string();
  return scene;
}

Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                const TextCheck& textCheck) {
  return parseScene(textOf(path), path.string(), overrides, textCheck);
}

}  // namespace poinsot::scene
