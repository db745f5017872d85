// SPDX-License-Identifier: Apache-2.0
#include "app/interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "core/error.h"

namespace poinsot::app {
namespace {

volatile std::sig_atomic_t firstSignal = 0;
int wakePipe[2] = {-1, -1};

extern "C" void noteSignal(int signal) {
  if (firstSignal != 0 && signal == SIGINT) _exit(128 + signal);
  if (firstSignal != 0) return;
  firstSignal = signal;
  const int saved = errno;
  // One byte into an empty pipe cannot fail; the flag is what counts.
  [[maybe_unused]] const auto written = write(wakePipe[1], "!", 1);
  errno = saved;
}

void watch(int signal) {
  struct sigaction before {};
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = noteSignal;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

void openWakePipe() {
  if (wakePipe[0] < 0 && pipe2(wakePipe, O_CLOEXEC | O_NONBLOCK) != 0)
    throw core::Error(core::ErrorKind::kIo, "cannot open a pipe");
}

}  // namespace

void watchInterrupts() {
  openWakePipe();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) watch(signal);
}

void watchInterruptsAsWorker() {
  openWakePipe();
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGHUP, SIG_IGN);
  watch(SIGTERM);
}

int interruptSignal() { return firstSignal; }

int interruptFd() { return wakePipe[0]; }

void throwIfInterrupted() {
  if (firstSignal != 0) throw Interrupted(firstSignal);
}

}  // namespace poinsot::app
