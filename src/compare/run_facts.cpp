// SPDX-License-Identifier: Apache-2.0
#include "compare/run_facts.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <optional>
#include <sstream>
#include <system_error>

#include "core/error.h"
#include "core/regular_file.h"
#include "core/shell_word.h"
#include "figure/mark.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) try {
  constexpr std::size_t kMost = std::size_t{16} << 20;  // enough for git's packed-refs in large projects
  std::string text = core::readRegularFile(file, kMost, core::ErrorKind::kIo);
  while (text.ends_with('\n')) text.pop_back();
  return text;
} catch (const core::Error&) {
  return "";
}

bool isCommit(const std::string& text) {
  return (text.size() == 40 || text.size() == 64) &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isxdigit(c); });
}

std::string after(const std::string& text, std::string_view prefix) {
  return text.starts_with(prefix) ? text.substr(prefix.size()) : "";
}

/// Returns the git folder of a work tree: .git or, in a linked work tree, the folder that the file .git names.
/// Empty if the folder is not a work tree.
fs::path gitFolderIn(const fs::path& folder) {
  std::error_code ignored;
  const fs::path git = folder / ".git";
  if (fs::is_directory(git, ignored)) return git;
  const std::string other = after(textOf(git), "gitdir: ");
  return other.empty() ? fs::path() : folder / other;
}

/// Returns the commit of a ref such as "refs/heads/main".
/// @param packed  lines such as "HASH refs/heads/main"
std::string packedCommit(const std::string& packed, const std::string& ref) {
  std::istringstream lines(packed);
  for (std::string line; std::getline(lines, line);)
    if (line.ends_with(" " + ref)) return line.substr(0, line.find(' '));
  return "";
}

std::string commitOf(const fs::path& git, const std::string& ref) {
  const std::string commonWord = textOf(git / "commondir");  // this file exists in linked work trees only
  const fs::path common = commonWord.empty() ? git : git / commonWord;
  for (const fs::path& folder : {git, common})
    if (const std::string commit = textOf(folder / ref); isCommit(commit)) return commit;
  return packedCommit(textOf(common / "packed-refs"), ref);
}

std::string dateText() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  std::array<char, 64> text{};
  if (!localtime_r(&now, &local)) return "";
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S %z", &local)};
}

std::string machineText() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// Returns this process's command line, with the program's name instead of its path. Empty if the command line
/// cannot be read, as in a sandbox.
std::string commandText() {
  std::istringstream all(textOf("/proc/self/cmdline"));
  std::vector<std::string> words;
  for (std::string word; std::getline(all, word, '\0');) words.push_back(word);
  if (!words.empty()) words.front() = fs::path(words.front()).filename();
  return core::shellWords(words);
}

}  // namespace

std::optional<fs::path> workTreeAround(const fs::path& place) {
  std::error_code failure;
  for (fs::path folder = fs::weakly_canonical(fs::absolute(place), failure); !failure;
       folder = folder.parent_path()) {
    if (!gitFolderIn(folder).empty()) return folder;
    if (folder == folder.parent_path()) return std::nullopt;
  }
  return std::nullopt;
}

std::string commitAround(const fs::path& place) {
  const auto tree = workTreeAround(place);
  if (!tree) return "";
  const fs::path git = gitFolderIn(*tree);
  const std::string head = textOf(git / "HEAD"), ref = after(head, "ref: ");
  const bool isRef = ref.starts_with("refs/") && ref.find("..") == std::string::npos;
  const std::string commit = isRef ? commitOf(git, ref) : head;
  return isCommit(commit) ? commit : "";
}

std::vector<std::pair<std::string, std::string>> runFacts(const fs::path& place) {
  std::vector<std::pair<std::string, std::string>> facts{{"date", dateText()},
                                                         {"commit", commitAround(place)},
                                                         {"machine", machineText()},
                                                         {"program", figure::creator()},
                                                         {"command", commandText()}};
  std::erase_if(facts, [](const auto& fact) { return fact.second.empty(); });
  return facts;
}

}  // namespace poinsot::compare
