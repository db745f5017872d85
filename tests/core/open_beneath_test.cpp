// SPDX-License-Identifier: Apache-2.0
// openBeneath() opens nothing outside its folder, both with openat2 and folder by folder.
#include "core/open_beneath.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <string>
#include <thread>

#include "support/scratch_folder.h"

namespace poinsot::core {
namespace {

namespace fs = std::filesystem;

std::string textOf(const FileHandle& file) {
  char text[64] = {};
  const ssize_t count = file ? read(file.get(), text, sizeof text) : -1;
  return count < 0 ? "nothing" : std::string(text, static_cast<std::size_t>(count));
}

class OpenBeneath : public testing::TestWithParam<Following> {
 protected:
  OpenBeneath() : root_(scratch_ / "root") {
    fs::create_directories(root_ / "below");
    scratch_.put("secret", "outside");
    scratch_.put("root/a", "beside");
    scratch_.put("root/below/b", "below");
  }

  FileHandle open(const fs::path& path) const { return openBeneath(root_, path, GetParam()); }

  int reasonOf(const fs::path& path) const {
    const FileHandle file = open(path);
    return file ? 0 : errno;
  }

  const ScratchFolder scratch_;
  const fs::path root_;
};

TEST_P(OpenBeneath, FindsFilesInAndBelowTheFolder) {
  EXPECT_EQ(textOf(open("a")), "beside");
  EXPECT_EQ(textOf(open("./below//b")), "below");
  EXPECT_EQ(textOf(openBeneath(root_ / "below", "b", GetParam())), "below");
}

TEST_P(OpenBeneath, FollowsALinkToTheFolderItself) {
  fs::create_directory_symlink(root_, scratch_ / "link");
  EXPECT_EQ(textOf(openBeneath(scratch_ / "link", "a", GetParam())), "beside");
}

TEST_P(OpenBeneath, RefusesLinksAndPathsOutOfTheFolder) {
  fs::create_symlink(scratch_ / "secret", root_ / "to_secret");
  fs::create_symlink("a", root_ / "to_a");
  fs::create_directory_symlink("..", root_ / "up");
  fs::create_directory_symlink("below", root_ / "down");
  EXPECT_EQ(reasonOf("../secret"), EXDEV);
  EXPECT_EQ(reasonOf("below/../../secret"), EXDEV);
  EXPECT_EQ(reasonOf(scratch_ / "secret"), EXDEV);
  EXPECT_EQ(reasonOf("/proc/self/environ"), EXDEV);
  EXPECT_EQ(reasonOf("to_secret"), ELOOP);
  EXPECT_EQ(reasonOf("to_a"), ELOOP);  // links inside the folder are refused too
  EXPECT_EQ(reasonOf("up/secret"), ELOOP);
  EXPECT_EQ(reasonOf("down/b"), ELOOP);
}

TEST_P(OpenBeneath, OpensOnlyRegularFiles) {
  ASSERT_EQ(mkfifo((root_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(reasonOf("pipe"), EINVAL);
  EXPECT_EQ(reasonOf("below"), EISDIR);
  EXPECT_EQ(reasonOf("."), EISDIR);
  EXPECT_EQ(reasonOf("none"), ENOENT);
  EXPECT_EQ(reasonOf("a/b"), ENOTDIR);
  EXPECT_EQ(reasonOf("a/"), ENOTDIR);
  EXPECT_EQ(reasonOf(std::string(300, 'x')), ENAMETOOLONG);
  EXPECT_FALSE(openBeneath("/dev", "zero", GetParam()));
  EXPECT_EQ(errno, EINVAL);
  EXPECT_FALSE(openBeneath("/nowhere", "a", GetParam()));
  EXPECT_EQ(errno, ENOENT);
}

// A writer that waits for a reader must not be woken.
TEST_P(OpenBeneath, DoesNotWakeTheWriterOfAPipe) {
  ASSERT_EQ(mkfifo((root_ / "pipe").c_str(), 0600), 0);
  std::atomic<bool> woken = false;
  std::jthread writer([&] {
    FileHandle end(::open((root_ / "pipe").c_str(), O_WRONLY | O_CLOEXEC));
    woken = true;
  });
  for (int i = 0; i < 100; ++i) EXPECT_EQ(reasonOf("pipe"), EINVAL);
  EXPECT_FALSE(woken);
  const FileHandle reader(::open((root_ / "pipe").c_str(), O_RDONLY | O_CLOEXEC));  // releases the writer
}

// One thread keeps exchanging a folder and a link to the outside. Every open finds the file beneath, or fails.
TEST_P(OpenBeneath, StaysInsideDuringARaceWithALink) {
  scratch_.put("b", "outside");
  fs::create_directory_symlink(scratch_.path(), root_ / "link");
  std::atomic<bool> done = false;
  std::jthread mischief([&] {
    while (!done)
      syscall(SYS_renameat2, AT_FDCWD, (root_ / "below").c_str(), AT_FDCWD, (root_ / "link").c_str(),
              2);  // exchange
  });
  int opened = 0, refused = 0;
  bool left = false;
  while ((opened < 500 || refused < 500) && opened + refused < 1'000'000 && !left) {
    const FileHandle file = open("below/b");
    left = file && textOf(file) != "below";
    ++(file ? opened : refused);
  }
  done = true;
  EXPECT_FALSE(left);
  EXPECT_GE(opened, 500);
  EXPECT_GE(refused, 500);
}

INSTANTIATE_TEST_SUITE_P(Both, OpenBeneath, testing::Values(Following::kByTheKernel, Following::kFolderByFolder),
                         [](const auto& each) {
                           return each.param == Following::kByTheKernel ? "ByTheKernel" : "FolderByFolder";
                         });

/// Makes openat2 fail with errno `reason` in this process from now on.
void forbidOpenat2(unsigned int reason) {
  sock_filter code[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat2, 0, 1),
                        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | reason),
                        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog program{4, code};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
    _exit(9);
}

// Old kernels fail with ENOSYS, the sandboxes of containers with EPERM.
TEST(OpenBeneathWithoutOpenat2, FallsBackToOpeningFolderByFolder) {
  const ScratchFolder folder;
  folder.put("a", "beside");
  fs::create_symlink("a", folder / "link");
  for (const unsigned int reason : {ENOSYS, EPERM}) {
    const pid_t child = fork();
    if (child == 0) {
      forbidOpenat2(reason);
      const bool found = textOf(openBeneath(folder.path(), "a")) == "beside";
      const bool refused = !openBeneath(folder.path(), "link") && errno == ELOOP;
      _exit(found && refused ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0) << reason;
  }
}

}  // namespace
}  // namespace poinsot::core
