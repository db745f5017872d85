// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <future>
#include <list>
#include <memory>
#include <thread>

#include "physics/driven_motion.h"
#include "scene/scene.h"

namespace poinsot::python {

/// Cache of a scene's latest motions, so that a driven motion is integrated once for each span of time. A longer
/// span has other steps and other last bits, so no motion replaces another: a result depends on its span alone.
class Motions {
 public:
  using Made = std::shared_ptr<const physics::Motion>;

  /// Returns the motion over the least span that holds both times and 0. Call it without the GIL, from any thread.
  /// One thread integrates a span, and others that need the span wait; Ctrl-C ends both. If a signal's handler
  /// needs the span that its own thread is integrating, it gets a motion of its own. In a fork, unfinished motions
  /// begin anew.
  /// @throws core::Error as scene::makeMotion().
  Made over(const scene::Scene& scene, double from_s, double to_s);

 private:
  struct Entry {
    Entry(const physics::TimeSpan& itsSpan, pid_t itsProcess) : span(itsSpan), process(itsProcess) {}
    bool isMade() const;

    physics::TimeSpan span;
    pid_t process;
    std::thread::id maker = std::this_thread::get_id();
    std::promise<Made> promise;  // null if the maker failed
    std::shared_future<Made> made{promise.get_future()};
  };
  using SharedEntry = std::shared_ptr<Entry>;

  struct Claim {
    SharedEntry entry;
    bool isNew;
  };

  Claim claim(const physics::TimeSpan& span);
  Made make(const scene::Scene& scene, const SharedEntry& entry);

  std::list<SharedEntry> entries_;  // the latest first
};

}  // namespace poinsot::python
