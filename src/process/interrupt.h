// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>
#include <cstdint>
#include <exception>

#include "core/abi.h"

/// SIGINT, SIGTERM and SIGHUP as something a loop can ask for, in place of sudden death: the caller unwinds,
/// removes what it had begun and ends with 128 + signal.
namespace poinsot::process {

/// Thrown where a loop sees that the user or the system wants the program to end.
class Interrupted : public std::exception {
 public:
  explicit Interrupted(int signal) : signal_(signal) {}
  int signal() const { return signal_; }
  const char* what() const noexcept override { return "interrupted"; }

 private:
  int signal_;
};

/// From now on the three signals are noted, and throwIfInterrupted() is the core::InterruptionCheck of this
/// thread. One that was ignored at the start (nohup) stays so. A SIGINT more than half a second after the first
/// signal ends the process at once. Call it on the main thread.
void watchInterrupts();
/// The same in a forked worker, which knows nothing of what its parent noted. It notes only SIGTERM: a terminal
/// sends Ctrl-C to the whole group, and the parent decides what becomes of its workers.
void watchInterruptsAsWorker();

/// Holds the three signals back while it lives: around a fork, or a worker could take one for its parent.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// The first signal noted, or 0.
int interruptSignal();

/// Readable once a signal was noted, for poll(). -1, which poll() passes over, before watchInterrupts().
int interruptFd();

/// @throws Interrupted once a signal was noted; core::Error(kLimit) if the time is over (limitTime()).
void throwIfInterrupted();

/// Ends this process after so many seconds by the clock, as a limit that was exceeded. Where interrupts are
/// watched throwIfInterrupted() throws core::Error(kLimit) then, so that what is complete is kept; where nothing
/// looks for them, or for 5 s more, the process says why and ends with `exitCode` at once.
/// @pre seconds > 0.
void limitTime(std::int64_t seconds, int exitCode);

}  // namespace poinsot::process
