// SPDX-License-Identifier: Apache-2.0
#include "core/atomic_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "support/folder_test.h"

namespace poinsot::core {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr auto kIo = ErrorKind::kIo;

const Bytes kOld = {'o', 'l', 'd'};
const Bytes kNew = {'n', 'e', 'w', '!'};

class AtomicFileTest : public FolderTest {};

TEST_F(AtomicFileTest, AppearsOnlyOnCommit) {
  AtomicFile file(in("a.bin"));
  file.write(kNew);
  EXPECT_FALSE(std::filesystem::exists(in("a.bin")));
  EXPECT_EQ(file.temporary().parent_path(), file.target().parent_path());
  file.commit();
  EXPECT_EQ(content(in("a.bin")), kNew);
  EXPECT_THAT(names(), ElementsAre("a.bin"));
}

TEST_F(AtomicFileTest, KeepsTheOldFileWithoutCommit) {
  save("a.bin", "old");
  { AtomicFile(in("a.bin")).write(kNew); }
  EXPECT_EQ(content(in("a.bin")), kOld);
  EXPECT_THAT(names(), ElementsAre("a.bin"));
}

TEST_F(AtomicFileTest, ReplacesOnCommit) {
  save("a.bin", "old");
  writeFileAtomically(in("a.bin"), kNew, Durability::kRenamed);
  EXPECT_EQ(content(in("a.bin")), kNew);
}

TEST_F(AtomicFileTest, GivesTwoWritersSeparateTemporaryFiles) {
  AtomicFile first(in("a.bin")), second(in("a.bin"));
  EXPECT_NE(first.temporary(), second.temporary());
  second.write(kNew);
  first.write(kOld);
  second.commit();
  first.commit();
  EXPECT_EQ(content(in("a.bin")), kOld);  // the last commit wins
  EXPECT_THAT(names(), ElementsAre("a.bin"));
}

TEST_F(AtomicFileTest, DoesNotFollowALinkAtTheTemporaryPath) {
  save("precious", "old");
  std::filesystem::path expected;
  { expected = AtomicFile(in("a.bin")).temporary(); }
  std::filesystem::create_symlink(in("precious"), expected);
  writeFileAtomically(in("a.bin"), kNew);
  EXPECT_EQ(content(in("precious")), kOld);
  EXPECT_EQ(content(in("a.bin")), kNew);
}

TEST_F(AtomicFileTest, ReplacesALinkNotItsTarget) {
  save("precious", "old");
  std::filesystem::create_symlink(in("precious"), in("a.bin"));
  writeFileAtomically(in("a.bin"), kNew);
  EXPECT_EQ(content(in("precious")), kOld);
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(in("a.bin"))));
}

TEST_F(AtomicFileTest, WorksWithTheLongestName) {
  const std::string name(255, 'n');
  writeFileAtomically(in(name), kNew);
  EXPECT_EQ(content(in(name)), kNew);
  EXPECT_THAT(messageOf(kIo, [&] { writeFileAtomically(in(name + "n"), kNew); }), HasSubstr("File name too long"));
  EXPECT_THAT(names(), ElementsAre(name));
}

TEST_F(AtomicFileTest, ReportsPathAndReasonOfFailure) {
  const auto message = [&](const std::filesystem::path& target) {
    return messageOf(kIo, [&] { writeFileAtomically(target, kNew); });
  };
  EXPECT_THAT(message(in("none/a.bin")),
              StartsWith(in("none/a.bin").native() + ": cannot be created: No such file"));
  save("file", "old");
  EXPECT_THAT(message(in("file/a.bin")), HasSubstr("Not a directory"));
  std::filesystem::create_directories(in("full/inside"));
  EXPECT_THAT(message(in("full")), HasSubstr("cannot be put in place: Is a directory"));
  EXPECT_THAT(names(), ElementsAre("file", "full"));
  EXPECT_THAT(message("/proc/a.bin"), StartsWith("/proc/a.bin: cannot be created"));
}

// A limit on file size stands in for a full disk: one write is short, the next one fails.
TEST_F(AtomicFileTest, ReportsAFullDisk) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = messageOf(kIo, [&] { writeFileAtomically(in("a.bin"), Bytes(1001)); });
  writeFileAtomically(in("fits.bin"), Bytes(1000));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, in("a.bin").native() + ": cannot be written: File too large");
  EXPECT_THAT(names(), ElementsAre("fits.bin"));
}

TEST_F(AtomicFileTest, RejectsUseAfterCommit) {
  AtomicFile file(in("a.bin"));
  file.commit();
  EXPECT_THROW(file.commit(), std::logic_error);
  EXPECT_THROW(file.write(kNew), std::logic_error);
}

TEST(WriteAll, ReturnsErrnoOnFailure) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  EXPECT_EQ(writeAll(full, kNew), ENOSPC);
  ::close(full);
  EXPECT_EQ(writeAll(-1, kNew), EBADF);
}

// A pipe accepts only part of a write while its reader is slow. All bytes must still arrive.
TEST(WriteAll, ResumesShortWrites) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  Bytes sent(300'000);
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    ::_exit(writeAll(ends[1], sent) == 0 ? 0 : 1);
  }
  ::close(ends[1]);
  Bytes received, chunk(4096);
  for (ssize_t n = 0; (n = ::read(ends[0], chunk.data(), chunk.size())) > 0;)
    received.insert(received.end(), chunk.begin(), chunk.begin() + n);
  ::close(ends[0]);
  EXPECT_EQ(received, sent);
}

TEST(FolderOf, IsTheParentOrTheCurrentFolder) {
  EXPECT_EQ(folderOf("a/b.png"), "a");
  EXPECT_EQ(folderOf("b.png"), ".");
  EXPECT_EQ(folderOf("/b.png"), "/");
}

}  // namespace
}  // namespace poinsot::core
