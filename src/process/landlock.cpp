// SPDX-License-Identifier: Apache-2.0
#include "process/landlock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::process {
namespace {

// Landlock constants that Debian 12's headers lack. The version of the kernel determines which are supported.
constexpr std::uint64_t kTruncate = 1ULL << 14, kDeviceControl = 1ULL << 15;
constexpr std::uint64_t kBindAndConnect = 3;     // TCP
constexpr std::uint64_t kSocketsAndSignals = 3;  // access to processes outside the sandbox
constexpr int kWithRenaming = 2, kWithTruncate = 3, kWithNetwork = 4, kWithDevices = 5, kWithScopes = 6;

struct Handled {
  std::uint64_t files = 0, network = 0, scopes = 0;
};

constexpr std::uint64_t kReadingFile = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t kReading = kReadingFile | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kWritingFile = LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;
constexpr std::uint64_t kWriting = kWritingFile | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                   LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                   LANDLOCK_ACCESS_FS_REFER;
constexpr std::uint64_t kNever = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                 LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                 LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM | kDeviceControl;

std::uint64_t knownRights(int version) {
  std::uint64_t rights = kReading | kWriting | kNever;
  if (version < kWithTruncate) rights &= ~kTruncate;
  if (version < kWithDevices) rights &= ~kDeviceControl;
  return rights;
}

[[noreturn]] void failRule(const std::string& why) { throw core::graphicsError("--untrusted: " + why); }

int versionOfKernel() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version >= kWithRenaming) return static_cast<int>(version);
  failRule(
      fmt::format("this kernel cannot restrict a process to its files ({}); Linux 5.19 or later with Landlock "
                  "enabled is needed",
                  version < 0 ? core::systemReason(errno) : "its Landlock is too old"));
}

core::FileHandle makeRules(int version) {
  Handled handled{knownRights(version)};
  std::size_t size = sizeof handled.files;
  if (version >= kWithNetwork) {
    handled.network = kBindAndConnect;
    size += sizeof handled.network;
  }
  if (version >= kWithScopes) {
    handled.scopes = kSocketsAndSignals;
    size += sizeof handled.scopes;
  }
  return core::FileHandle(static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, size, 0)));
}

}  // namespace

Landlock::Landlock() : version_(versionOfKernel()), rules_(makeRules(version_)) {
  if (!rules_) failRule("cannot create rules for files: " + core::systemReason(errno));
}

void Landlock::mayRead(const std::filesystem::path& path) { allow(path, kReading); }

void Landlock::mayWrite(const std::filesystem::path& path) { allow(path, kReading | kWriting); }

void Landlock::allow(const std::filesystem::path& path, unsigned long long rights) {
  const core::FileHandle file(::open(path.c_str(), O_PATH | O_CLOEXEC));
  if (!file && (errno == ENOENT || errno == ENOTDIR)) return;
  struct stat facts {};
  if (!file || ::fstat(file.get(), &facts) != 0)
    throw core::ioError(fmt::format("{}: {}", core::printable(path.native()), core::systemReason(errno)));
  if (!S_ISDIR(facts.st_mode)) rights &= kReadingFile | kWritingFile;
  landlock_path_beneath_attr rule{};
  rule.allowed_access = rights & knownRights(version_);
  rule.parent_fd = file.get();
  if (syscall(SYS_landlock_add_rule, rules_.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
    failRule(
        fmt::format("cannot add a rule for {}: {}", core::printable(path.native()), core::systemReason(errno)));
}

void Landlock::enforce() const {
  if (syscall(SYS_landlock_restrict_self, rules_.get(), 0) != 0)
    failRule("cannot enforce the rules for files: " + core::systemReason(errno));
}

}  // namespace poinsot::process
