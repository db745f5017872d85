// SPDX-License-Identifier: Apache-2.0
// A place that cannot hold an output is refused before the first frame. Closed streams do not become outputs.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>

#include "faults/tiny_film.h"
#include "support/sanitized.h"
#include "support/shell_run.h"

namespace poinsot::faults {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct BadPlace {
  const char* name;
  std::string target;
  const char* says;
  const char* before = ":";  ///< commands that prepare the place
};

void PrintTo(const BadPlace& place, std::ostream* out) { *out << place.says; }

class BadOutputPath : public testing::TestWithParam<BadPlace> {
 protected:
  void SetUp() override {
    folder_.put("tiny.toml", kTinyScene);
    ::chmod(folder_.path().c_str(), 0755);
  }

  /// Returns the program, run as nobody if the test runs as root, because root may write anywhere.
  static std::string program() {
    const std::string other = "setpriv --reuid=65534 --regid=65534 --clear-groups ";
    return (::geteuid() == 0 ? other : "") + POINSOT_PROGRAM;
  }

  ScratchFolder folder_;
};

// Takes the least CPU time of three runs. Measured 0.04 s.
TEST_P(BadOutputPath, IsRejectedBeforeTheFirstFrame) {
  const BadPlace& place = GetParam();
  ASSERT_EQ(runShell(folder_.path(), place.before).exitCode, 0);
  const std::string command =
      "exec " + program() + " render tiny.toml --progress json -j 1 --size 64x36 -o '" + place.target + "'";
  double least_s = 1e9;
  for (int i = 0; i < 3; ++i) {
    const ShellResult refused = runShell(folder_.path(), command);
    least_s = std::min(least_s, refused.cpu_s);
    if (refused.exitCode == 126) GTEST_SKIP() << "nobody may run the program where it was built: " << refused.out;
    EXPECT_EQ(refused.exitCode, 4) << refused.out;
    EXPECT_THAT(refused.out, HasSubstr(place.says));
    EXPECT_THAT(refused.out, Not(HasSubstr(R"("progress")")));
  }
  EXPECT_LE(least_s, 0.3);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadOutputPath,
    testing::Values(BadPlace{"NotOurs", "t.mp4", "cannot be written to: Permission denied"},
                    BadPlace{"NotOursForASequence", "t_{frame}.png", "cannot be written to: Permission denied"},
                    BadPlace{"NoFolder", "no/such/t.mp4", "no such folder; make it with: mkdir -p no/such"},
                    BadPlace{"NoFolderForASequence", "no/such/t_{frame}.png", "no such folder"},
                    BadPlace{"InAFile", "tiny.toml/t.mp4", "not a folder"},
                    BadPlace{"AFolder", "t.mp4", "is a folder", "mkdir t.mp4 && chmod 777 ."},
                    BadPlace{"APipe", "t.mp4", "is a pipe", "mkfifo t.mp4 && chmod 777 ."},
                    BadPlace{"ALink", "t.mp4", "is a symbolic link", "ln -s /dev/null t.mp4 && chmod 777 ."},
                    BadPlace{
                        "ASocket", "t.mp4", "is a device or socket",
                        "perl -MIO::Socket::UNIX -e 'IO::Socket::UNIX->new(Local => \"t.mp4\", Listen => 1)' && "
                        "chmod 777 ."},
                    BadPlace{"TooLong", std::string(252, 'n') + ".mp4", "File name too long", "chmod 777 ."},
                    BadPlace{"TooLongForASequence", std::string(250, 'n') + "_{frame}.png", "File name too long",
                             "chmod 777 ."}),
    [](const auto& each) { return std::string(each.param.name); });

// A file name may have at most 255 bytes. Temporary files beside the output must not have longer names.
TEST(LongFileName, IsAcceptedForAFilm) {
  for (const std::size_t length : {std::size_t{243}, std::size_t{251}}) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    const Output film{std::string(length, 'n') + ".mp4", 0.6};
    const RunResult made = run(folder, renderArguments(film));
    EXPECT_EQ(made.exitCode, 0) << length << made.err;
  }
}

// A chroot may have no /proc.
TEST(MissingProcFolder, DoesNotChangeTheFilm) {
  POINSOT_NOT_SANITIZED("its library reads /proc");
  if (::geteuid() != 0) GTEST_SKIP() << "only root may hide /proc";
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  std::string command =
      "exec unshare -m sh -c 'mount -t tmpfs none /proc && [ ! -e /proc/self ] && " POINSOT_PROGRAM;
  for (const std::string& word : renderArguments(kShortFilm)) command += ' ' + word;
  const ShellResult made = runShell(folder.path(), command + "'");
  if (made.out.find("unshare:") != std::string::npos || made.out.find("mount:") != std::string::npos)
    GTEST_SKIP() << "not allowed here: " << made.out;
  EXPECT_EQ(made.exitCode, 0) << made.out;
  EXPECT_EQ(filesOf(folder.path()), undisturbed(kShortFilm));
}

class ClosedStreams : public testing::TestWithParam<const char*> {};

// open() returns the lowest free descriptor. If that were 1 or 2, messages would go into the film.
TEST_P(ClosedStreams, AreNotReusedForOutputs) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  std::string command = POINSOT_PROGRAM;
  for (const std::string& word : renderArguments(kShortFilm, {"--progress", "plain", "--stats"}))
    command += ' ' + word;
  EXPECT_EQ(runShell(folder.path(), command + ' ' + GetParam()).exitCode, 0);
  EXPECT_EQ(filesOf(folder.path()), undisturbed(kShortFilm));
}

std::string streamsOf(const testing::TestParamInfo<const char*>& info) {
  const char* const names[] = {"Input", "Output", "Messages", "All"};
  return names[info.index];
}

INSTANTIATE_TEST_SUITE_P(Each, ClosedStreams, testing::Values("<&-", ">&-", "2>&-", "<&- >&- 2>&-"), streamsOf);

}  // namespace
}  // namespace poinsot::faults
