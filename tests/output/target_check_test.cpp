// SPDX-License-Identifier: Apache-2.0
#include "output/target_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "core/file_error.h"
#include "decoded_film.h"
#include "output/film.h"
#include "output/png_sequence.h"
#include "output/video_segment.h"
#include "support/folder_test.h"

namespace poinsot::output {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class TargetCheckTest : public FolderTest {
 protected:
  static std::string refusal(const std::filesystem::path& target, bool force = false) {
    return messageOf(core::ErrorKind::kIo, [&] { checkTarget(target, force); });
  }
  std::string sequenceRefusal(const std::string& name, std::int64_t last = 3, bool force = false) const {
    return messageOf(core::ErrorKind::kIo, [&] { checkSequence(FramePattern(in(name)), 0, last, force); });
  }
};

TEST_F(TargetCheckTest, AcceptsANewFileAndCreatesNothing) {
  EXPECT_EQ(refusal(in("new.png")), "");
  EXPECT_EQ(sequenceRefusal("f_{frame}.png"), "");
  EXPECT_EQ(sequenceRefusal("new/f_{frame}.png"), "");  // its folder will be made
  EXPECT_TRUE(names().empty());
}

TEST_F(TargetCheckTest, RejectsPathsThatCannotBeFiles) {
  EXPECT_EQ(refusal(in("none/a.png")),
            in("none").native() + ": no such folder; make it with: mkdir -p " + in("none").native());
  EXPECT_THAT(refusal(in("it's new/a.png")), testing::EndsWith("/it'\\''s new'"));
  save("file", "x");
  EXPECT_THAT(refusal(in("file/a.png")), HasSubstr("file: not a folder"));
  EXPECT_THAT(sequenceRefusal("no/such/f_{frame}.png"), HasSubstr("no: no such folder"));
  EXPECT_THAT(sequenceRefusal("file/f_{frame}.png"), HasSubstr("not a folder"));
  EXPECT_THAT(refusal(in("")), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(in("..")), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(in(std::string(256, 'n'))), HasSubstr("File name too long"));
}

TEST_F(TargetCheckTest, ErrorsContainTheErrnoOfOpen) {
  const auto codeAt = [&](const std::string& name) {
    try {
      checkTarget(in(name), false);
    } catch (const core::FileError& error) {
      return error.code();
    }
    return 0;
  };
  save("file", "x");
  std::filesystem::create_directory(in("folder"));
  EXPECT_EQ(codeAt("none/a.png"), ENOENT);
  EXPECT_EQ(codeAt("file/a.png"), ENOTDIR);
  EXPECT_EQ(codeAt("folder"), EISDIR);
  EXPECT_EQ(codeAt("file"), EEXIST);
  EXPECT_EQ(codeAt(std::string(256, 'n')), ENAMETOOLONG);
}

TEST_F(TargetCheckTest, RefusesNonRegularFilesEvenWithForce) {
  std::filesystem::create_directory(in("folder.png"));
  std::filesystem::create_symlink(in("elsewhere.png"), in("link.png"));
  ASSERT_EQ(::mkfifo(in("fifo.png").c_str(), 0600), 0);
  for (const bool force : {false, true}) {
    EXPECT_THAT(refusal(in("folder.png"), force), HasSubstr("is a folder"));
    EXPECT_THAT(refusal(in("link.png"), force), HasSubstr("is a symbolic link"));
    EXPECT_THAT(refusal(in("fifo.png"), force), HasSubstr("is a pipe"));
    EXPECT_THAT(refusal("/dev/full", force), HasSubstr("/dev/full: is a device"));
  }
}

TEST_F(TargetCheckTest, ReplacesOnlyFilesOfPoinsot) {
  save("precious.png", "x");
  EXPECT_EQ(refusal(in("precious.png")),
            in("precious.png").native() + ": exists and was not written by poinsot; --force replaces it");
  EXPECT_EQ(refusal(in("precious.png"), true), "");
  writePng(in("own.png"), movingDisc({8, 8}, 0));
  EXPECT_EQ(refusal(in("own.png")), "");
  VideoSegmentWriter segment(in("own.mp4"), {16, 16}, {30, 1}, h264(18), 0);
  segment.write({movingDisc({16, 16}, 0)}, 0);
  segment.finish();
  EXPECT_EQ(refusal(in("own.mp4")), "");
  save("own.mp4", "x");
  EXPECT_THAT(refusal(in("own.mp4")), HasSubstr("--force"));
}

TEST_F(TargetCheckTest, ChecksEveryFrameOfASequence) {
  writePng(in("f_0.png"), movingDisc({8, 8}, 0));
  save("f_3.png", "x");
  EXPECT_EQ(sequenceRefusal("f_{frame}.png", 2), "");
  EXPECT_THAT(sequenceRefusal("f_{frame}.png", 3), HasSubstr("f_3.png: exists"));
  EXPECT_EQ(sequenceRefusal("f_{frame}.png", 3, true), "");
}

// Root may write anywhere, so that a child process gives up root first.
TEST_F(TargetCheckTest, RefusesAFolderWithoutWritePermission) {
  if (::geteuid() != 0) {
    ::chmod(in("").c_str(), 0500);
    EXPECT_THAT(refusal(in("a.png")), HasSubstr("cannot be written to: Permission denied"));
    ::chmod(in("").c_str(), 0700);
    return;
  }
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (::setgid(kNobody) != 0 || ::setuid(kNobody) != 0) ::_exit(2);
    const std::string message = refusal(in("a.png"));
    ::_exit(message.find("cannot be written to: Permission denied") == std::string::npos ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace poinsot::output
