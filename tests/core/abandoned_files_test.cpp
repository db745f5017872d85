// SPDX-License-Identifier: Apache-2.0
// Who removes the hidden file of a process that was killed: the next one that makes a file in the same folder.
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
  /// A process that has begun a file. @returns its number, once the file is there.
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

  /// Another run that writes a file.
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
  const pid_t first = begin("a.png"), second = begin(std::string(255, 'n'));  // a name that is cut
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

// Each differs in one thing from a file that is removed.
TEST_F(AbandonedFiles, AreRemovedOnlyIfNothingSpeaksAgainstIt) {
  const pid_t ended = begin("a");
  end(ended);
  std::filesystem::remove(in(names().front()));
  const std::string number = std::to_string(ended), space = processSpace();
  ASSERT_EQ(space.size(), 12U);
  std::vector<std::string> stay{"a." + number + "-0." + space + ".tmp",    // not hidden
                                "." + number + "-0." + space + ".tmp",     // of no name
                                ".a." + number + "-0." + space + ".txt",   // not temporary
                                ".a." + number + "-0.tmp",                 // of no known machine
                                ".a." + number + "-0.0123456789ab.tmp",    // of another machine
                                ".a." + number + "." + space + ".tmp",     // no attempt
                                ".a." + number + "x-0." + space + ".tmp",  // no number
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
