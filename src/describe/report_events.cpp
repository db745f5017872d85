// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/error.h"
#include "describe/report_sections.h"
#include "scene/motion/scene_events.h"
#include "stage/picture_motion.h"

namespace poinsot::describe {
namespace {

void addKind(Section& section, const std::vector<scene::SceneEvent>& events, std::size_t kind) {
  std::vector<double> motion_s, film_s;
  for (const scene::SceneEvent& event : events) {
    if (static_cast<std::size_t>(event.kind) != kind || !event.film) continue;
    motion_s.push_back(event.t_s);
    film_s.push_back(event.film->from_s);
  }
  if (motion_s.empty()) return;
  const scene::EventKind& it = scene::eventKinds()[kind];
  section.add(fmt::format("{}_times", it.word), std::string(it.plural), std::move(motion_s), "s",
              std::string(it.meaning));
  section.add(fmt::format("{}_film_times", it.word), "  in the film at", std::move(film_s), "s", "film time");
}

}  // namespace

Section eventsSection(const scene::Scene& scene, const physics::Motion& motion, const ReportSpan& span) {
  Section section{"Events in the film (at motion times)", {}};
  try {
    const auto events =
        scene::sceneEvents(scene, motion, stage::filmClock(scene), physics::TimeSpan{span.from_s, span.to_s});
    for (std::size_t kind = 0; kind < scene::eventKinds().size(); ++kind) addKind(section, events, kind);
  } catch (const core::Error& error) {
    if (error.kind() != core::ErrorKind::kLimit) throw;  // a film with so many events needs no list of them
  }
  return section;
}

}  // namespace poinsot::describe
