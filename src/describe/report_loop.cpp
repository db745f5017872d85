// SPDX-License-Identifier: Apache-2.0
#include "describe/report_loop.h"

#include <fmt/format.h>
#include <numbers>

#include "describe/report_sections.h"

namespace poinsot::describe {

namespace {

double speedChange(const scene::Loop& loop, const scene::Time& time) { return *time.speed / loop.speedAsked - 1; }

}  // namespace

Section loopSection(const scene::Scene& scene) {
  Section section{"Film that repeats (time.loop)", {}};
  if (!scene.time.loop) return section;
  const scene::Loop& loop = *scene.time.loop;
  section.add("loop_period", "time after which the motion repeats", loop.period_s, "s", "attitude and omega");
  const bool isTop = !scene.motion.forcing.none();
  if (!isTop)
    section.add("loop_polhode_periods", "  periods of the polhode in that time", loop.polhodePeriods, "",
                "0: a steady spin");
  section.add("loop_turns", isTop ? "  turns about the vertical in that time" : "  turns about L in that time",
              loop.turns, "", "");
  section.add("loop_omega_change", "change of omega at the start, relative to |omega|", loop.change, "",
              isTop ? "at the same lean" : "at the same |L|");
  section.add("loop_omega_turned", "  change of its direction in the body", loop.turned_rad, "rad", "");
  section.addDetail("loop_speed_before", "speed before", loop.speedAsked, "", "motion s per film s");
  section.add("loop_speed", "speed of the film that repeats", *scene.time.speed, "", "");
  section.addDetail("loop_duration_before", "film before", loop.durationAsked_s, "s", "time.duration");
  section.add("loop_duration", "film that repeats", scene.time.duration_s, "s", "whole frames");
  section.addDetail("loop_mismatch", "attitudes at its two ends differ by", loop.mismatch_rad, "rad", "rounding");
  return section;
}

std::string loopText(const scene::Loop& loop, const scene::Time& time) {
  return fmt::format(
      "the film repeats after {:.4g} s; omega at the start changed by {:.2g} deg ({:.2g} %), speed from "
      "{:.4g} to {:.4g} ({:+.2g} %)",
      time.duration_s, loop.turned_rad * 180 / std::numbers::pi, 100 * loop.change, loop.speedAsked, *time.speed,
      100 * speedChange(loop, time));
}

}  // namespace poinsot::describe
