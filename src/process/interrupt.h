// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>
#include <cstdint>
#include <exception>

#include "core/abi.h"

/// Handling of SIGINT, SIGTERM and SIGHUP: loops check for a signal, which does not kill the process. The caller
/// can unwind, remove unfinished files and exit with 128 + signal.
namespace poinsot::process {

/// Exception for a signal that asks the program to end.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  int signal() const { return signal_; }
  const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// Records SIGINT, SIGTERM and SIGHUP from now on, and makes throwIfInterrupted() the core::InterruptionCheck of
/// this thread. A signal that was ignored at the start (nohup) stays ignored. A SIGINT more than half a second
/// after the first signal ends the process at once. Call this function on the main thread.
void watchInterrupts();
/// Records SIGTERM in a forked worker, and discards what its parent recorded. SIGINT and SIGHUP are ignored: a
/// terminal sends Ctrl-C to the whole process group, and the parent decides when its workers stop.
void watchInterruptsAsWorker();

/// Blocks SIGINT, SIGTERM and SIGHUP around a fork, so that a worker takes no signal meant for its parent.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// Returns the first recorded signal; 0 if there is none.
int interruptSignal();

/// Returns a descriptor for poll(), readable after a signal; before watchInterrupts() -1, which poll() ignores.
int interruptFd();

/// @throws Interrupted after a signal; core::Error(kLimit) after the time limit of limitTime().
void throwIfInterrupted();

/// Limits the wall time of this process. At the limit, throwIfInterrupted() throws core::Error(kLimit), so that
/// completed work is kept. Without watchInterrupts(), or if the process has not ended 5 s later, it prints the
/// reason and exits with `exitCode`.
/// @pre seconds > 0.
void limitTime(std::int64_t seconds, int exitCode);

}  // namespace poinsot::process
