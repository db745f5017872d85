// SPDX-License-Identifier: Apache-2.0
#include "core/abandoned_files.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "core/kernel_start.h"
#include "core/number.h"

namespace poinsot::core {
namespace {

namespace fs = std::filesystem;

std::optional<std::string_view> takeLast(std::string_view& name, char mark) {
  const auto at = name.rfind(mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view part = name.substr(at + 1);
  name = name.substr(0, at);
  return part;
}

std::optional<pid_t> numberOf(std::optional<std::string_view> digits) {
  const auto number = digits ? parseInteger<pid_t>(*digits) : std::nullopt;
  return number && *number >= 0 ? number : std::nullopt;
}

/// Returns the PID from the name of a temporary file (temporaryName()). Returns nullopt for other names, and for
/// files of another PID namespace.
std::optional<pid_t> writerOf(std::string_view name) {
  const std::string& space = processSpace();
  if (space.empty() || !name.starts_with('.')) return std::nullopt;
  if (takeLast(name, '.') != "tmp" || takeLast(name, '.') != space || !numberOf(takeLast(name, '-')))
    return std::nullopt;
  const std::optional<pid_t> writer = numberOf(takeLast(name, '.'));
  return name.size() > 1 && writer && *writer > 0 ? writer : std::nullopt;
}

bool hasEnded(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

void removeAbandonedFiles(const fs::path& folder) {
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    const auto writer = writerOf(entry->path().filename().native());
    struct stat facts {};
    if (!writer || !hasEnded(*writer) || ::lstat(entry->path().c_str(), &facts) != 0) continue;
    if (S_ISREG(facts.st_mode) && facts.st_uid == ::geteuid()) ::unlink(entry->path().c_str());
  }
}

bool isFirst(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> seen;
  const std::lock_guard lock(mutex);
  return seen.insert(folder).second;
}

}  // namespace

fs::path temporaryName(const fs::path& folder, const fs::path& target, int attempt) {
  constexpr std::size_t kLongestStem = 200;  // leaves 55 of 255 bytes to PID, attempt and namespace
  const std::string stem = target.filename().native().substr(0, kLongestStem);
  const std::string& space = processSpace();
  return folder / fmt::format(".{}.{}-{}{}{}.tmp", stem, ::getpid(), attempt, space.empty() ? "" : ".", space);
}

void removeAbandonedFilesOnce(const fs::path& folder) noexcept {
  try {
    if (isFirst(fs::absolute(folder))) removeAbandonedFiles(folder);
  } catch (const std::exception&) {  // out of memory: the next run removes the files
  }
}

}  // namespace poinsot::core
