// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "physics/driven_motion.h"
#include "scene/scene.h"

namespace poinsot::python {

/// Keeps the latest few motions of a scene, so that a driven one is integrated once for each span of time. A
/// longer span has other steps and other last bits, so none stands for another: what a caller gets depends on the
/// span alone.
class Motions {
 public:
  /// The motion over the least span that holds these two times and 0. Call it without the GIL, from any thread:
  /// one thread integrates a span, and others that ask for it wait. Ctrl-C ends both.
  /// @throws core::Error as scene::makeMotion().
  std::shared_ptr<const physics::Motion> over(const scene::Scene& scene, double from_s, double to_s);

 private:
  struct Entry {
    physics::TimeSpan span;
    std::timed_mutex making;
    std::shared_ptr<const physics::Motion> motion;  // guarded by `making`
  };

  std::shared_ptr<Entry> entryOf(const physics::TimeSpan& span);

  std::mutex mutex_;
  std::list<std::shared_ptr<Entry>> entries_;  // the latest first
};

}  // namespace poinsot::python
