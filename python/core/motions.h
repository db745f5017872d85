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

/// Keeps the latest few motions of a scene, so that a driven one is integrated once for each span of time. A
/// longer span has other steps and other last bits, so none stands for another: what a caller gets depends on the
/// span alone.
class Motions {
 public:
  using Made = std::shared_ptr<const physics::Motion>;

  /// Returns the motion over the least span that holds these two times and 0. Call it without the GIL, from any
  /// thread: one thread integrates a span, and others that ask for it wait. Ctrl-C ends both. A signal's handler
  /// may ask on the thread that is integrating: it gets a motion of its own. In a fork, motions begun before are
  /// begun anew.
  /// @throws core::Error as scene::makeMotion().
  Made over(const scene::Scene& scene, double from_s, double to_s);

 private:
  /// A motion that a thread makes or has made.
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
    bool isNew;  // to be made by the caller
  };

  Claim claim(const physics::TimeSpan& span);
  Made make(const scene::Scene& scene, const SharedEntry& entry);

  std::list<SharedEntry> entries_;  // the latest first
};

}  // namespace poinsot::python
