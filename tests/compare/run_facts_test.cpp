// SPDX-License-Identifier: Apache-2.0
// The layout of .git follows gitrepository-layout(5) and packed-refs of gitformat-pack; the files are written by
// hand.
#include "compare/run_facts.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <map>

#include "core/version.h"
#include "support/scratch_folder.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;

const std::string kCommit = "0123456789abcdef0123456789abcdef01234567", kOther(40, 'e');

class CommitAround : public ::testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    folder_.put(name, text);
  }

  ScratchFolder folder_;
};

TEST_F(CommitAround, FollowsABranch) {
  put(".git/HEAD", "ref: refs/heads/a/b\n");
  put(".git/refs/heads/a/b", kCommit + "\n");
  put("deep/er/x.png", "");
  EXPECT_EQ(commitAround(folder_.path()), kCommit);
  EXPECT_EQ(commitAround(folder_ / "deep/er/x.png"), kCommit);
  EXPECT_EQ(commitAround(folder_ / "deep/er"), kCommit);
}

TEST_F(CommitAround, ReadsADetachedHead) {
  put(".git/HEAD", kCommit + "\n");
  EXPECT_EQ(commitAround(folder_.path()), kCommit);
  const std::string sha256(64, 'a');
  put(".git/HEAD", sha256 + "\n");
  EXPECT_EQ(commitAround(folder_.path()), sha256);
}

TEST_F(CommitAround, FindsAPackedBranch) {
  put(".git/HEAD", "ref: refs/heads/main\n");
  put(".git/packed-refs", "# pack-refs with: peeled fully-peeled sorted\n" + kOther +
                              " refs/heads/not/refs/heads/main2\n" + kOther + " refs/remotes/main\n" + kCommit +
                              " refs/heads/main\n^" + kOther + "\n");
  EXPECT_EQ(commitAround(folder_.path()), kCommit);
  put(".git/refs/heads/main", kOther + "\n");  // newer than the pack
  EXPECT_EQ(commitAround(folder_.path()), kOther);
}

// The files are as `git worktree add` makes them.
TEST_F(CommitAround, FindsTheCommitOfALinkedWorkTree) {
  put("tree/.git", "gitdir: " + (folder_ / "main/.git/worktrees/tree").string() + "\n");
  put("main/.git/worktrees/tree/HEAD", "ref: refs/heads/side\n");
  put("main/.git/worktrees/tree/commondir", "../..\n");
  put("main/.git/refs/heads/side", kCommit + "\n");
  EXPECT_EQ(commitAround(folder_ / "tree"), kCommit);
}

TEST_F(CommitAround, IsEmptyWhereThereIsNoCommit) {
  EXPECT_EQ(commitAround(folder_.path()), "");
  EXPECT_EQ(commitAround(folder_ / "nowhere"), "");
  put(".git/HEAD", "ref: refs/heads/main\n");
  EXPECT_EQ(commitAround(folder_.path()), "") << "nothing was committed yet";
  put("secret", kCommit);
  put(".git/HEAD", "ref: refs/../../secret\n");
  EXPECT_EQ(commitAround(folder_.path()), "") << "leads out of .git";
  put(".git/HEAD", "ref: ../secret\n");
  EXPECT_EQ(commitAround(folder_.path()), "");
  put(".git/HEAD", "<script>\n");
  EXPECT_EQ(commitAround(folder_.path()), "");
}

TEST(RunFacts, NameMachineProgramAndCommand) {
  const ScratchFolder folder;
  const auto facts = runFacts(folder.path());
  const std::map<std::string, std::string> found(facts.begin(), facts.end());
  std::array<char, 256> name{};
  ASSERT_EQ(gethostname(name.data(), name.size() - 1), 0);
  EXPECT_EQ(found.at("machine"), name.data());
  EXPECT_EQ(found.at("program"), std::string("poinsot ") + core::version());
  EXPECT_EQ(found.at("command").substr(0, 12), "compare_test");
  EXPECT_FALSE(found.contains("commit"));
}

}  // namespace
}  // namespace poinsot::compare
