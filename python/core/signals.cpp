// SPDX-License-Identifier: Apache-2.0
#include "signals.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <thread>

namespace poinsot::python {
namespace {

unsigned long mainThread = 0;
std::atomic<bool> ending = false;
std::atomic<int> returning = 0;  // threads that wait for the GIL

/// Corrects the state in a fork, whose only thread is the main one.
void beginFork() {
  mainThread = PyThread_get_thread_ident();
  returning = 0;
}

bool isMainThread() { return PyThread_get_thread_ident() == mainThread; }

}  // namespace

void rememberMainThread() {
  mainThread =
      pybind11::cast<unsigned long>(pybind11::module_::import("threading").attr("main_thread")().attr("ident"));
  pthread_atfork(nullptr, nullptr, beginFork);
}

void checkSignals() {
  if (!isMainThread()) return;
  const pybind11::gil_scoped_acquire held;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

WithoutGil::~WithoutGil() {
  ++returning;
  if (ending && !isMainThread()) {
    --returning;
    while (true) pause();
  }
  others_.reset();
  --returning;
}

void leaveThreadsAlone() {
  ending = true;
  while (returning > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace poinsot::python
