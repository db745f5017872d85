// SPDX-License-Identifier: Apache-2.0
// The hidden file of a killed process is removed by the next process that makes a file in the same folder.
#include "core/abandoned_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "core/atomic_file.h"
#include "core/kernel_start.h"
#include "support/folder_test.h"

namespace poinsot::core {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAreArray;

class AbandonedFiles : public FolderTest {
 protected:
  /// Forks a process that begins a file. @returns the process id, after the file exists.
  pid_t begin(const std::string& name) const {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t process = ::fork();
    if (process == 0) {
      const AtomicFile file(in(name));
      if (::write(ends[1], "x", 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    char told = 0;
    EXPECT_EQ(::read(ends[0], &told, 1), 1);
    ::close(ends[0]);
    ::close(ends[1]);
    return process;
  }

  static void end(pid_t process) {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
  }

  /// Writes other.txt from another process.
  void runAgain() const {
    const pid_t process = ::fork();
    if (process == 0) {
      writeFileAtomically(in("other.txt"), std::string_view("new"));
      ::_exit(0);
    }
    int status = -1;
    ::waitpid(process, &status, 0);
    EXPECT_EQ(status, 0);
  }
};

TEST_F(AbandonedFiles, AreRemovedByTheNextRunInTheFolder) {
  const pid_t first = begin("a.png"), second = begin(std::string(255, 'n'));  // the hidden name is shortened
  end(first);
  end(second);
  ASSERT_EQ(names().size(), 2U);
  runAgain();
  EXPECT_THAT(names(), ElementsAre("other.txt"));
}

TEST_F(AbandonedFiles, StayWhileTheirProcessLives) {
  const pid_t living = begin("a.png");
  runAgain();
  EXPECT_EQ(names().size(), 2U);
  end(living);
  runAgain();
  EXPECT_THAT(names(), ElementsAre("other.txt"));
}

// Each file differs in one property from a file that is removed.
TEST_F(AbandonedFiles, StayIfNameProcessOrFileTypeDiffers) {
  const pid_t ended = begin("a");
  end(ended);
  std::filesystem::remove(in(names().front()));
  const std::string number = std::to_string(ended), space = processSpace();
  ASSERT_EQ(space.size(), 12U);
  std::vector<std::string> stay{"a." + number + "-0." + space + ".tmp",    // not hidden
                                "." + number + "-0." + space + ".tmp",     // no target name
                                ".a." + number + "-0." + space + ".txt",   // not temporary
                                ".a." + number + "-0.tmp",                 // no machine identifier
                                ".a." + number + "-0.0123456789ab.tmp",    // another machine
                                ".a." + number + "." + space + ".tmp",     // no attempt number
                                ".a." + number + "x-0." + space + ".tmp",  // process id is not a number
                                ".a.-1-0." + space + ".tmp",
                                ".a.0-0." + space + ".tmp",
                                ".a." + std::to_string(::getpid()) + "-0." + space + ".tmp"};
  for (const std::string& name : stay) save(name, "x");
  stay.push_back(".b." + number + "-0." + space + ".tmp");
  std::filesystem::create_directory(in(stay.back()));
  stay.push_back(".c." + number + "-0." + space + ".tmp");
  std::filesystem::create_symlink("other.txt", in(stay.back()));
  save(".d." + number + "-0." + space + ".tmp", "goes");
  runAgain();
  stay.push_back("other.txt");
  EXPECT_THAT(names(), UnorderedElementsAreArray(stay));
}

}  // namespace
}  // namespace poinsot::core
