// SPDX-License-Identifier: Apache-2.0
// SIGKILL leaves temporary folders on disk and in memory. The next program that makes such a folder removes them.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include "core/file_handle.h"
#include "faults/tiny_film.h"
#include "support/sanitized.h"

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// Returns the claimed folders in memory, of any program, whose processes have ended.
std::set<fs::path> abandonedInMemory() {
  std::set<fs::path> found;
  for (const auto& entry : fs::directory_iterator("/dev/shm")) {
    const core::FileHandle folder(open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder && fs::exists(entry.path() / ".poinsot-claim") && flock(folder.get(), LOCK_SH | LOCK_NB) == 0)
      found.insert(entry.path());
  }
  return found;
}

/// Returns whether a process of the group still runs. Zombies do not count, because they stay forever if nobody
/// waits for orphans.
bool anyLives(pid_t group) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string line;
    if (!std::getline(file, line)) continue;
    std::istringstream words(line.substr(line.rfind(')') + 1));
    char state = 0;
    pid_t parent = 0, itsGroup = 0;
    if (words >> state >> parent >> itsGroup && itsGroup == group && state != 'Z' && state != 'X') return true;
  }
  return false;
}

class Leftovers : public testing::TestWithParam<std::vector<std::string>> {
 protected:
  Leftovers() { folder_.put("tiny.toml", kTinyScene); }

  static bool isUntrusted() { return std::ranges::find(GetParam(), "--untrusted") != GetParam().end(); }

  std::unique_ptr<ProgramRun> start() const {
    return std::make_unique<ProgramRun>(folder_, GetParam(), Stdout::kFile,
                                        std::vector{"TMPDIR=" + temporary_.path().string()});
  }

  /// Kills only the parent, as an impatient `timeout` does; its forks end with it.
  static void killHard(ProgramRun& running) {
    const pid_t group = running.pid();
    running.signal(SIGKILL);
    running.wait();
    while (anyLives(group)) usleep(1000);
  }

  const ScratchFolder folder_, temporary_;
};

TEST_P(Leftovers, AreRemovedByTheNextRun) {
  std::size_t most = 0;
  std::set<fs::path> inMemory;
  // The folders appear, and the film is complete, at different times on different machines. The test therefore
  // waits longer and longer until all folders are left.
  for (int wait_ms = 5; wait_ms < 600 && (most == 0 || (isUntrusted() && inMemory.empty())); wait_ms += 15) {
    const auto running = start();
    usleep(1000 * wait_ms);
    killHard(*running);
    const std::size_t left = namesIn(temporary_.path()).size();
    EXPECT_LE(left, 1u) << "each start removes what the one before left; " << wait_ms;
    most = std::max(most, left);
    inMemory = abandonedInMemory();
  }
  EXPECT_EQ(most, 1u) << "there was something to remove";
  EXPECT_TRUE(!isUntrusted() || !inMemory.empty()) << "the shader cache's copy";
  EXPECT_EQ(start()->wait().exitCode, 0);
  EXPECT_THAT(namesIn(temporary_.path()), IsEmpty());
  for (const fs::path& folder : inMemory) EXPECT_TRUE(!isUntrusted() || !fs::exists(folder)) << folder;
}

// A hidden folder is not claimed yet. If another run removes it, its maker makes a new one.
bool isClaimed(const std::string& name) { return !name.starts_with('.'); }

TEST_P(Leftovers, AreKeptWhileTheirRunLives) {
  const auto living = start();
  while (std::ranges::none_of(namesIn(temporary_.path()), isClaimed)) usleep(1000);
  living->signal(SIGSTOP);
  const auto before = namesIn(temporary_.path());
  const auto other = start();
  EXPECT_EQ(other->wait().exitCode, 0);
  EXPECT_EQ(namesIn(temporary_.path()), before);
  living->signal(SIGCONT);
  EXPECT_EQ(living->wait().exitCode, 0);
  EXPECT_THAT(namesIn(temporary_.path()), IsEmpty());
}

std::vector<std::string> toStream() {
  return {"render", "tiny.toml", "-o", "-", "--format", "mp4", "--size", "64x36", "-j", "1", "--quiet"};
}

std::vector<std::vector<std::string>> runs() {
  std::vector<std::vector<std::string>> all{toStream()};
  if (!kSanitized) all.push_back(renderArguments(kFilm, {"--untrusted", "--force"}));  // see sandbox_test.cpp
  return all;
}

INSTANTIATE_TEST_SUITE_P(Each, Leftovers, testing::ValuesIn(runs()),
                         [](const auto& each) { return std::string(each.index == 0 ? "Stream" : "Untrusted"); });

}  // namespace
}  // namespace poinsot::faults
