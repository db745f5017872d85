// SPDX-License-Identifier: Apache-2.0
#include "process/interrupt.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace poinsot::process {
namespace {

constexpr int kUnwound = 7;  // exit status of a child that survives the second signal

/// Returns the exit status of a child that raises two signals with a pause between them: kUnwound if it survives
/// and has noted the first one.
int statusAfter(int first, int pause_us, int second) {
  const pid_t child = fork();
  if (child == 0) {
    watchInterrupts();
    raise(first);
    usleep(static_cast<useconds_t>(pause_us));
    raise(second);
    _exit(interruptSignal() == first ? kUnwound : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

TEST(Interrupt, IgnoresASecondSignalThatFollowsAtOnce) {
  EXPECT_EQ(statusAfter(SIGINT, 0, SIGINT), kUnwound);  // as `timeout -s INT` sends it
  EXPECT_EQ(statusAfter(SIGTERM, 0, SIGINT), kUnwound);
}

TEST(Interrupt, ExitsAtOnceOnASecondCtrlCAfterAPause) {
  EXPECT_EQ(statusAfter(SIGINT, 600'000, SIGINT), 128 + SIGINT);
  EXPECT_EQ(statusAfter(SIGINT, 600'000, SIGTERM), kUnwound);
}

}  // namespace
}  // namespace poinsot::process
