// SPDX-License-Identifier: Apache-2.0
// A temporary folder is removed by its own process or, after a SIGKILL, by the next process that makes one. Nobody
// removes the folder of a living process.
#include "core/abandoned_folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <vector>

#include "core/temporary_folder.h"
#include "support/scratch_folder.h"

namespace poinsot::core {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// Forked process that makes a temporary folder, fills it, and sleeps.
class Owner {
 public:
  Owner() {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
      const TemporaryFolder folder;
      fill(folder.path());
      const std::string path = folder.path();
      if (write(ends[1], path.data(), path.size()) < 0) _exit(1);
      for (;;) pause();
    }
    close(ends[1]);
    char path[4096];
    const ssize_t size = read(ends[0], path, sizeof path);
    close(ends[0]);
    folder_ = std::string(path, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  }
  ~Owner() { kill(); }
  Owner(const Owner&) = delete;

  const fs::path& folder() const { return folder_; }
  void kill() {
    if (process_ > 0) ::kill(process_, SIGKILL);
    if (process_ > 0) waitpid(process_, nullptr, 0);
    process_ = -1;
  }

 private:
  static void fill(const fs::path& folder) {
    fs::create_directories(folder / "a" / "b");
    std::ofstream(folder / "a" / "b" / "file") << "text";
    fs::create_symlink(folder.parent_path() / "not ours", folder / "a" / "link");
    fs::create_directory_symlink(folder.parent_path() / "others", folder / "links");
  }

  pid_t process_ = -1;
  fs::path folder_;
};

class AbandonedFolders : public testing::Test {
 protected:
  AbandonedFolders() {
    setenv("TMPDIR", place_.path().c_str(), 1);
    place_.put("not ours", "stays");
    fs::create_directory(place_ / "others");
    std::ofstream(place_ / "others" / "file") << "stays";
  }
  ~AbandonedFolders() override {
    EXPECT_EQ(fs::file_size(place_ / "not ours"), 5u);
    EXPECT_EQ(fs::file_size(place_ / "others" / "file"), 5u);
    unsetenv("TMPDIR");
  }

  static fs::path abandoned() {
    Owner owner;
    owner.kill();
    return owner.folder();
  }

  /// Returns the temporary folders that still exist, hidden ones included.
  std::vector<std::string> left() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(place_.path()))
      if (entry.path().filename().native().find("poinsot-") != std::string::npos) names.push_back(entry.path());
    return names;
  }

  /// Changes the owner of a path, or its mode if the test does not run as root.
  static void giveAway(const fs::path& path) {
    if (::chown(path.c_str(), 65534, 65534) != 0) ::chmod(path.c_str(), 0500);
  }

  const ScratchFolder place_;
};

TEST_F(AbandonedFolders, AreRemovedWhenTheNextFolderIsCreated) {
  const fs::path first = abandoned(), second = abandoned();
  EXPECT_FALSE(fs::exists(first));  // removed when the second was made
  EXPECT_TRUE(fs::exists(second / "a" / "b" / "file"));
  const TemporaryFolder next;
  EXPECT_FALSE(fs::exists(second));
  EXPECT_TRUE(fs::exists(next.path()));
}

TEST_F(AbandonedFolders, StayWhileTheirProcessLives) {
  Owner owner;
  const TemporaryFolder next;
  removeAbandonedFolders(place_.path());
  EXPECT_TRUE(fs::exists(owner.folder() / "a" / "b" / "file"));
  EXPECT_TRUE(fs::exists(next.path()));
  owner.kill();
  removeAbandonedFolders(place_.path());
  EXPECT_FALSE(fs::exists(owner.folder()));
  EXPECT_TRUE(fs::exists(next.path()));
}

TEST_F(AbandonedFolders, StayWhileAForkOfTheirProcessLives) {
  auto [path, claim] = makeClaimedFolder(place_.path());
  ASSERT_TRUE(claim);
  const pid_t fork = ::fork();
  if (fork == 0)
    for (;;) pause();
  claim.reset();
  removeAbandonedFolders(place_.path());
  EXPECT_TRUE(fs::exists(path));
  kill(fork, SIGKILL);
  waitpid(fork, nullptr, 0);
  removeAbandonedFolders(place_.path());
  EXPECT_FALSE(fs::exists(path));
}

// Each folder differs in one property from a folder that is removed.
TEST_F(AbandonedFolders, StayIfModeClaimNameOrOwnerDiffers) {
  const std::string claim = ".poinsot-claim";
  const std::vector<std::function<void(const fs::path&)>> differences{
      [](const fs::path& folder) { ::chmod(folder.c_str(), 0755); },
      [](const fs::path& folder) { ::chmod(folder.c_str(), 01700); },
      [&](const fs::path& folder) { fs::remove(folder / claim); },
      [&](const fs::path& folder) { std::ofstream(folder / claim) << "another start of the kernel"; },
      [&](const fs::path& folder) { std::ofstream(folder / claim) << ""; },
      [&](const fs::path& folder) { ::chmod((folder / claim).c_str(), 0666); },
      [&](const fs::path& folder) {
        fs::rename(folder / claim, place_ / "claim");
        fs::create_symlink(place_ / "claim", folder / claim);
      },
      [](const fs::path& folder) { fs::rename(folder, folder.string() + "x"); },
      [&](const fs::path& folder) {
        fs::rename(folder, place_ / "elsewhere");
        fs::create_directory_symlink(place_ / "elsewhere", folder);
      },
      [](const fs::path& folder) { giveAway(folder); },
      [&](const fs::path& folder) { giveAway(folder / claim); }};
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const fs::path folder = abandoned();
    const auto parent = folder.parent_path();
    differences[i](folder);
    const auto files = [&] {
      return std::distance(fs::recursive_directory_iterator(parent), fs::recursive_directory_iterator());
    };
    const auto before = files();
    removeAbandonedFolders(parent);
    EXPECT_EQ(files(), before) << i;
    for (const auto& entry : fs::directory_iterator(parent))
      if (entry.path().filename() != "not ours" && entry.path().filename() != "others") fs::remove_all(entry);
  }
}

/// Covers every state that a kill between two system calls can leave while a folder is made or removed.
TEST_F(AbandonedFolders, AreRemovedIfPartlyCreatedOrPartlyRemoved) {
  const std::string claim = ".poinsot-claim";
  const std::vector<std::function<void(const fs::path&)>> states{
      [](const fs::path&) {},                                                 // complete
      [](const fs::path& folder) { fs::remove_all(folder / "a"); },           // partly removed
      [&](const fs::path& folder) { fs::remove(folder / claim); },            // empty
      [&](const fs::path& folder) { std::ofstream(folder / claim) << ""; }};  // claim not written yet
  for (std::size_t i = 0; i < states.size(); ++i) {
    const fs::path folder = abandoned(), hidden = place_ / ("." + folder.filename().native());
    fs::rename(folder, hidden);
    if (i > 1) {
      fs::remove_all(hidden / "a");
      fs::remove(hidden / "links");
    }
    states[i](hidden);
    removeAbandonedFolders(place_.path());
    EXPECT_FALSE(fs::exists(hidden)) << i;
  }
}

/// An empty folder may be one that another program has just made with mktemp.
TEST_F(AbandonedFolders, DoNotIncludeEmptyFoldersOfOtherPrograms) {
  const ScratchFolder others;
  ASSERT_TRUE(others.path().filename().native().starts_with("poinsot-"));
  removeAbandonedFolders(others.path().parent_path());
  EXPECT_TRUE(fs::exists(others.path()));
}

/// Kills a process that makes and removes folders, after 20 us, 60 us and so on up to 6 ms.
TEST_F(AbandonedFolders, AreRemovedAfterAKillAtAnyMoment) {
  for (int wait_us = 20; wait_us < 6000; wait_us += 40) {
    const pid_t owner = fork();
    if (owner == 0)
      for (;;) const TemporaryFolder folder;
    usleep(static_cast<useconds_t>(wait_us));
    ::kill(owner, SIGKILL);
    waitpid(owner, nullptr, 0);
  }
  removeAbandonedFolders(place_.path());
  EXPECT_THAT(left(), IsEmpty());
}

TEST_F(AbandonedFolders, AreRemovedIfManyProcessesStartAtOnce) {
  std::vector<Owner> owners(12);
  for (Owner& owner : owners) owner.kill();
  std::vector<pid_t> starters;
  for (int i = 0; i < 16; ++i) {
    starters.push_back(fork());
    if (starters.back() != 0) continue;
    const TemporaryFolder folder;
    for (int again = 0; again < 20; ++again) removeAbandonedFolders(folder.path().parent_path());
    std::ofstream(folder.path() / "file") << "whole";
    _exit(fs::exists(folder.path() / "file") ? 0 : 1);  // leaves it, as if killed
  }
  for (const pid_t starter : starters) {
    int status = -1;
    waitpid(starter, &status, 0);
    EXPECT_EQ(status, 0);
  }
  removeAbandonedFolders(place_.path());
  EXPECT_THAT(left(), IsEmpty());
}

}  // namespace
}  // namespace poinsot::core
