// SPDX-License-Identifier: Apache-2.0
#include "motions.h"

#include <algorithm>

#include "scene/make_motion.h"
#include "signals.h"

namespace poinsot::python {
namespace {

constexpr std::size_t kMost = 4;  // of up to 60 MB each; most take some kB

}  // namespace

std::shared_ptr<const physics::Motion> Motions::over(const scene::Scene& scene, double from_s, double to_s) {
  const physics::TimeSpan span{std::min(from_s, 0.0), std::max(to_s, 0.0)};
  const std::shared_ptr<Entry> entry = entryOf(span);
  std::unique_lock making(entry->making, std::defer_lock);
  while (!making.try_lock_for(kPatience)) checkSignals();
  if (!entry->motion) entry->motion = scene::makeMotion(scene, span.from_s, span.to_s);
  return entry->motion;
}

std::shared_ptr<Motions::Entry> Motions::entryOf(const physics::TimeSpan& span) {
  const std::scoped_lock lock(mutex_);
  const auto same = [&](const auto& entry) {
    return entry->span.from_s == span.from_s && entry->span.to_s == span.to_s;
  };
  if (const auto found = std::ranges::find_if(entries_, same); found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front();
  }
  if (entries_.size() >= kMost) entries_.pop_back();
  entries_.push_front(std::make_shared<Entry>());
  entries_.front()->span = span;
  return entries_.front();
}

}  // namespace poinsot::python
