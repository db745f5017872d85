// SPDX-License-Identifier: Apache-2.0
#include "core/regular_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <string>
#include <utility>

#include "core/file_error.h"
#include "support/scratch_folder.h"

namespace poinsot::core {
namespace {

/// Returns the error's kind and message, or "read" if the file was read.
std::pair<ErrorKind, std::string> refusal(const std::filesystem::path& path, std::size_t mostBytes) {
  try {
    readRegularFile(path, mostBytes, ErrorKind::kScene);
  } catch (const Error& error) {
    return {error.kind(), error.message()};
  }
  return {ErrorKind::kUsage, "read"};
}

TEST(RegularFile, ReadsFilesUpToTheLimit) {
  const ScratchFolder folder;
  const std::string bytes("a\0\n\xff b", 6);
  const std::filesystem::path file = folder.put("bytes", bytes);
  EXPECT_EQ(readRegularFile(file, 6, ErrorKind::kIo), bytes);
  EXPECT_EQ(readRegularFile(folder.put("empty", ""), 0, ErrorKind::kIo), "");
  const auto [kind, message] = refusal(file, 5);
  EXPECT_EQ(kind, ErrorKind::kLimit);
  EXPECT_EQ(message, "cannot read " + file.string() + ": it has 6 bytes, more than the allowed 5");
}

// A sparse file of a terabyte must be refused by its size, before anything is read.
TEST(RegularFile, RejectsALargeFileBeforeReadingIt) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.put("large", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);
  EXPECT_EQ(refusal(file, 1 << 20).second,
            "cannot read " + file.string() + ": it has 1099511627776 bytes, more than the allowed 1048576");
}

// Files in /proc report a size of 0.
TEST(RegularFile, EnforcesTheLimitIfTheReportedSizeIsZero) {
  EXPECT_EQ(refusal("/proc/self/maps", 10).first, ErrorKind::kLimit);
}

TEST(RegularFile, RefusesPipesFoldersAndDevices) {
  const ScratchFolder folder;
  const std::filesystem::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  using Refusal = std::pair<ErrorKind, std::string>;
  EXPECT_EQ(refusal(pipe, 9),
            Refusal(ErrorKind::kScene, "cannot read " + pipe.string() + ": it is not a regular file"));
  EXPECT_EQ(refusal(folder.path(), 9),
            Refusal(ErrorKind::kScene, "cannot read " + folder.path().string() + ": it is a directory"));
  EXPECT_EQ(refusal(folder / "none", 9), Refusal(ErrorKind::kScene, "cannot read " + (folder / "none").string() +
                                                                        ": No such file or directory"));
  EXPECT_EQ(refusal("/dev/zero", 9),
            Refusal(ErrorKind::kScene, "cannot read /dev/zero: it is not a regular file"));
}

TEST(RegularFile, ErrorsContainFileNameAndErrno) {
  const ScratchFolder folder;
  const auto codeWhenReading = [](const std::filesystem::path& path) {
    try {
      readRegularFile(path, 1, ErrorKind::kIo);
    } catch (const FileError& error) {
      EXPECT_EQ(error.file(), path);
      return codeOf(error);
    }
    return -1;
  };
  const std::filesystem::path file = folder.put("file", "ab");
  EXPECT_EQ(codeWhenReading(folder / "none"), ENOENT);
  EXPECT_EQ(codeWhenReading(file / "below"), ENOTDIR);
  EXPECT_EQ(codeWhenReading(folder.path()), EISDIR);
  EXPECT_EQ(codeWhenReading("/dev/zero"), 0);  // no system call failed
  EXPECT_EQ(codeWhenReading(file), 0);         // too long
  EXPECT_EQ(codeOf(Error(ErrorKind::kIo, "full")), 0);
}

}  // namespace
}  // namespace poinsot::core
