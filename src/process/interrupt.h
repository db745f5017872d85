// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>
#include <cstdint>
#include <exception>

#include "core/abi.h"

/// Handling of SIGINT, SIGTERM and SIGHUP. A signal does not kill the process: loops check for signals and throw
/// an exception. The program can thus remove unfinished files, and then exits with 128 + signal.
namespace poinsot::process {

/// Exception for a signal that requests the end of the program.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  int signal() const { return signal_; }
  const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// Starts to record SIGINT, SIGTERM and SIGHUP, and makes throwIfInterrupted() the core::InterruptionCheck of this
/// thread. Signals that were ignored at the start (nohup) stay ignored. A SIGINT more than half a second after the
/// first signal ends the process immediately. Call this function on the main thread.
void watchInterrupts();
/// Starts to record SIGTERM in a forked worker, and forgets the signals that the parent recorded. Ignores SIGINT
/// and SIGHUP: a terminal sends them to all processes of the group, and the parent stops its workers with SIGTERM.
void watchInterruptsAsWorker();

/// Scope that blocks SIGINT, SIGTERM and SIGHUP during a fork. A new worker could otherwise handle a signal that
/// was sent to its parent.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// Returns the first recorded signal, or 0 if there is none.
int interruptSignal();

/// Returns a descriptor for poll(), readable after a signal. Before watchInterrupts(), returns -1, which poll()
/// ignores.
int interruptFd();

/// @throws Interrupted after a signal; core::Error(kLimit) after the time limit of limitTime().
void throwIfInterrupted();

/// Limits the wall time of this process. At the limit, throwIfInterrupted() throws core::Error(kLimit), so that
/// the program can keep completed work. If the process is still running 5 s later, or did not call
/// watchInterrupts(), prints the reason and exits with `exitCode`.
/// @pre seconds > 0.
void limitTime(std::int64_t seconds, int exitCode);

}  // namespace poinsot::process
