// SPDX-License-Identifier: Apache-2.0
#include "motions.h"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "scene/motion/make_motion.h"
#include "signals.h"

namespace poinsot::python {
namespace {

constexpr std::size_t kMost = 4;  // up to 60 MB each; most take some kB

/// Guards the lists of all scenes; never held while a motion is made. A fork takes it, so that the child gets
/// complete lists and a mutex that it can lock.
std::mutex listing;
[[maybe_unused]] const int forking =
    pthread_atfork([] { listing.lock(); }, [] { listing.unlock(); }, [] { listing.unlock(); });

}  // namespace

bool Motions::Entry::isMade() const { return made.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

Motions::Made Motions::over(const scene::Scene& scene, double from_s, double to_s) {
  const physics::TimeSpan span{std::min(from_s, 0.0), std::max(to_s, 0.0)};
  while (true) {
    const auto [entry, isNew] = claim(span);
    if (isNew) return make(scene, entry);
    if (!entry->isMade() && entry->maker == std::this_thread::get_id())
      return scene::makeMotion(scene, span.from_s, span.to_s);
    while (entry->made.wait_for(kPatience) != std::future_status::ready) checkSignals();
    if (Made motion = entry->made.get()) return motion;
  }
}

Motions::Made Motions::make(const scene::Scene& scene, const SharedEntry& entry) {
  try {
    Made motion = scene::makeMotion(scene, entry->span.from_s, entry->span.to_s);
    entry->promise.set_value(motion);
    return motion;
  } catch (...) {
    {
      const std::scoped_lock lock(listing);
      entries_.remove(entry);
    }
    entry->promise.set_value(nullptr);
    throw;
  }
}

Motions::Claim Motions::claim(const physics::TimeSpan& span) {
  const std::scoped_lock lock(listing);
  const pid_t process = getpid();
  // In a fork, the thread that was making an unfinished motion does not exist.
  std::erase_if(entries_, [&](const SharedEntry& entry) { return entry->process != process && !entry->isMade(); });
  const auto same = [&](const SharedEntry& entry) {
    return entry->span.from_s == span.from_s && entry->span.to_s == span.to_s;
  };
  if (const auto found = std::ranges::find_if(entries_, same); found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return {entries_.front(), false};
  }
  if (entries_.size() >= kMost) entries_.pop_back();
  entries_.push_front(std::make_shared<Entry>(span, process));
  return {entries_.front(), true};
}

}  // namespace poinsot::python
