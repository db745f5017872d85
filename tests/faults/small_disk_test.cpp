// SPDX-License-Identifier: Apache-2.0
// Uses a real disk that is full: a tmpfs of a few kilobytes in a mount namespace of the test. Needs root.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

std::string quoted(const std::string& word) { return "'" + word + "'"; }

std::string commandLine(const Output& output, const std::vector<std::string>& more) {
  std::string line = quoted(POINSOT_PROGRAM);
  for (const std::string& word : renderArguments(output, more)) line += " " + quoted(word);
  return line;
}

int inNamespace(const ScratchFolder& folder, const std::string& script) {
  folder.put("script.sh", script);
  const std::string line = "unshare -m sh " + quoted((folder / "script.sh").string());
  return WEXITSTATUS(std::system(line.c_str()));  // NOLINT: words of this test only
}

std::vector<int> numbersOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<int> numbers;
  for (int number = 0; stream >> number;) numbers.push_back(number);
  return numbers;
}

class SmallDisk : public testing::TestWithParam<Output> {};

TEST_P(SmallDisk, ExitsWith4AndAllowsResumeOnceEnlarged) {
  const ScratchFolder probe;
  if (geteuid() != 0 || inNamespace(probe, "mount -t tmpfs none /mnt\n") != 0)
    GTEST_SKIP() << "mounting needs root and a kernel that lets it";
  int full = 0;
  for (const int size_k : {16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 1024}) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    std::filesystem::create_directory(folder / "disk");
    std::filesystem::create_directory(folder / "made");
    const std::string script = "mount -t tmpfs -o size=" + std::to_string(size_k) + "k none " +
                               quoted((folder / "disk").string()) + " && cd " +
                               quoted((folder / "disk").string()) + " && cp ../tiny.toml . || exit 9\n" +
                               commandLine(GetParam(), {}) + " 2>../first.err; echo $? >../codes\n" +
                               "mount -o remount,size=64m . || exit 9\n" + commandLine(GetParam(), {"--resume"}) +
                               " 2>../second.err; echo $? >>../codes\n" + "cp t* ../made\n";
    ASSERT_EQ(inNamespace(folder, script), 0) << size_k;
    const std::vector<int> codes = numbersOf(bytesOf(folder / "codes"));
    ASSERT_EQ(codes.size(), 2u);
    EXPECT_THAT(codes[0], testing::AnyOf(0, 4)) << size_k << " KiB: " << bytesOf(folder / "first.err");
    EXPECT_EQ(codes[1], 0) << size_k << " KiB: " << bytesOf(folder / "second.err");
    EXPECT_EQ(filesOf(folder / "made"), undisturbed(GetParam())) << size_k << " KiB";
    full += codes[0] == 4 ? 1 : 0;
  }
  EXPECT_GE(full, 2);  // otherwise, the disks were too large for this test
}

INSTANTIATE_TEST_SUITE_P(Each, SmallDisk, testing::Values(kFilm, kSequence), kindOf);

}  // namespace
}  // namespace poinsot::faults
