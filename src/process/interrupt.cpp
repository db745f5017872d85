// SPDX-License-Identifier: Apache-2.0
#include "process/interrupt.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "core/error.h"
#include "core/expect.h"
#include "core/interruption.h"

namespace poinsot::process {

namespace {

// A SIGINT within this time after the first signal belongs to the same request: `timeout` sends two signals within
// microseconds, one to its child and one to the child's process group. A person takes longer to press Ctrl-C
// again.
constexpr std::int64_t kSameWish_ms = 500;

constexpr int kNoted[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic<int> firstSignal = 0;  // atomic, because threads of the preview read it
static_assert(std::atomic<int>::is_always_lock_free, "a handler may touch no other");
std::int64_t firstAt_ms = 0;  // used only in the signal handler, which blocks other signals
int wakePipe[2] = {-1, -1};
volatile std::sig_atomic_t watching = 0;
std::int64_t allowed_s = 0;
int exitCodeOfLimit = EXIT_FAILURE;
char tooLong[80] = "";  // message for noteAlarm(), prepared because a signal handler must not allocate memory

/// Returns a monotonic time in ms. Safe in a signal handler, because clock_gettime() is.
std::int64_t now_ms() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

void noteSignal(int signal) {
  const int saved = errno;
  if (firstSignal != 0 && signal == SIGINT && now_ms() - firstAt_ms > kSameWish_ms) _exit(128 + signal);
  if (firstSignal != 0) return;
  firstAt_ms = now_ms();
  firstSignal = signal;
  // The write may fail, because `firstSignal` alone is enough. A write of one byte to an empty pipe does not fail.
  [[maybe_unused]] const auto written = write(wakePipe[1], "!", 1);
  errno = saved;
}

void noteAlarm(int signal) {
  if (watching != 0 && firstSignal != signal) return noteSignal(signal);
  [[maybe_unused]] const auto written = write(STDERR_FILENO, tooLong, std::strlen(tooLong));
  _exit(exitCodeOfLimit);
}

sigset_t notedSignals() {
  sigset_t all{};
  sigemptyset(&all);
  for (const int signal : kNoted) sigaddset(&all, signal);
  return all;
}

void watch(int signal) {
  struct sigaction before {};
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = noteSignal;
  action.sa_mask = notedSignals();
  sigaction(signal, &action, nullptr);
}

void interruptComputations() { static const core::InterruptionCheck check(throwIfInterrupted); }

void openWakePipe() {
  if (wakePipe[0] < 0 && pipe2(wakePipe, O_CLOEXEC | O_NONBLOCK) != 0) throw core::ioError("cannot open a pipe");
}

}  // namespace

void watchInterrupts() {
  openWakePipe();
  for (const int signal : kNoted) watch(signal);
  watching = 1;
  interruptComputations();
}

void watchInterruptsAsWorker() {
  firstSignal = 0;
  wakePipe[0] = wakePipe[1] = -1;  // the old pipe belongs to the parent
  openWakePipe();
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGHUP, SIG_IGN);
  watch(SIGTERM);
  interruptComputations();
  const sigset_t held = notedSignals();  // SignalsHeld blocked them for the fork
  sigprocmask(SIG_UNBLOCK, &held, nullptr);
}

SignalsHeld::SignalsHeld() {
  const sigset_t held = notedSignals();
  sigprocmask(SIG_BLOCK, &held, &before_);
}

SignalsHeld::~SignalsHeld() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

int interruptSignal() { return firstSignal; }

int interruptFd() { return wakePipe[0]; }

void throwIfInterrupted() {
  if (firstSignal == SIGALRM)
    throw core::limitError(fmt::format("stopped after {} s, as set by --max-seconds", allowed_s));
  if (firstSignal != 0) throw Interrupted(firstSignal);
}

void limitTime(std::int64_t seconds, int exitCode) {
  POINSOT_EXPECT(seconds > 0);
  allowed_s = seconds;
  exitCodeOfLimit = exitCode;
  *fmt::format_to_n(tooLong, sizeof tooLong - 1, "poinsot: error: stopped after {} s, as set by --max-seconds\n",
                    seconds)
       .out = '\0';
  struct sigaction action {};
  action.sa_handler = noteAlarm;
  action.sa_mask = notedSignals();
  sigaction(SIGALRM, &action, nullptr);
  constexpr std::int64_t kPatience_s = 5;  // for code that rarely checks for signals, and for cleanup
  const itimerval times{{kPatience_s, 0}, {seconds, 0}};
  setitimer(ITIMER_REAL, &times, nullptr);
}

}  // namespace poinsot::process
