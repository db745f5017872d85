// SPDX-License-Identifier: Apache-2.0
#include "describe/report_loop.h"

#include <fmt/format.h>
#include <numbers>

#include "describe/report_sections.h"
#include "scene/motion/heavy_top_start.h"

namespace poinsot::describe {

namespace {

double speedChange(const scene::Loop& loop, const scene::Time& time) { return *time.speed / loop.speedAsked - 1; }

/// Returns the change of the start in words. A top keeps its lean, so its spin says more than omega.
std::string startText(const scene::Scene& scene) {
  const scene::Loop& loop = *scene.time.loop;
  if (!loop.spinAsked)
    return fmt::format("omega at the start changed by {:.2g} deg ({:.2g} %)",
                       loop.turned_rad * 180 / std::numbers::pi, 100 * loop.change);
  return fmt::format("spin from {:.5g} to {:.5g} rad/s", *loop.spinAsked, scene::heavyTopStart(scene)->spin());
}

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
  if (isTop) {
    section.addDetail("loop_spin_before", "spin before", *loop.spinAsked, "rad/s", "about the top's axis");
    section.addDetail("loop_spin", "spin of the film that repeats", scene::heavyTopStart(scene)->spin(), "rad/s",
                      "");
  }
  section.addDetail("loop_speed_before", "speed before", loop.speedAsked, "", "motion s per film s");
  section.add("loop_speed", "speed of the film that repeats", *scene.time.speed, "", "");
  section.addDetail("loop_duration_before", "film before", loop.durationAsked_s, "s", "time.duration");
  section.add("loop_duration", "film that repeats", scene.time.duration_s, "s", "whole frames");
  section.addDetail("loop_mismatch", "attitudes at its two ends differ by", loop.mismatch_rad, "rad", "rounding");
  return section;
}

std::string loopText(const scene::Scene& scene) {
  const scene::Time& time = scene.time;
  return fmt::format("the film repeats after {:.4g} s; {}, speed from {:.4g} to {:.4g} ({:+.2g} %)",
                     time.duration_s, startText(scene), time.loop->speedAsked, *time.speed,
                     100 * speedChange(*time.loop, time));
}

}  // namespace poinsot::describe
