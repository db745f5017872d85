// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <functional>
#include <memory>
#include <span>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/option_values.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/text.h"
#include "process/interrupt.h"
#include "reference/events.h"
#include "reference/trajectory.h"
#include "reference/trajectory_target.h"
#include "reference/trajectory_times.h"
#include "scene/motion/make_motion.h"
#include "scene/motion/scene_events.h"
#include "stage/picture_motion.h"

namespace poinsot::cli {
namespace {

struct TrajectoryOptions : SceneOptions {
  std::vector<std::string> at, quantities;
  std::string rate, output = "-";
  bool force = false, events = false;
};

constexpr const char* kQuantities = "--quantities";

reference::TrajectoryTimes listedTimes(const std::vector<std::string>& words) {
  std::vector<double> times_s;
  for (const std::string& word : words)
    for (const double t_s : parseTimes_s("--at", word)) times_s.push_back(t_s);
  return reference::TrajectoryTimes(std::move(times_s));
}

reference::ChosenColumns chosenColumns(const TrajectoryOptions& options, const scene::Scene& scene) {
  if (options.quantities.empty()) return reference::ChosenColumns(scene.motion.forcing.dissipation);
  std::vector<std::string> names;
  for (const std::string& list : options.quantities)
    for (std::string& name : reference::namesIn(list)) names.push_back(std::move(name));
  return {scene, names, kQuantities};
}

core::Rational parsedRate(const std::string& word) {
  const auto rate_hz = core::parseRational(word);
  if (!rate_hz)
    throw core::usageError(
        fmt::format("--rate '{}': must be the rows per second of motion, a plain number above 0 or a fraction, "
                    "such as 100, 0.5 or 30000/1001",
                    core::printable(word)));
  return *rate_hz;
}

reference::TrajectoryTimes requestedTimes(const TrajectoryOptions& options, const scene::Scene& scene) {
  if (options.rate.empty()) return listedTimes(options.at);
  return {parsedRate(options.rate), scene.time.start_s,
          stage::filmClock(scene).motionTime_s(scene.time.duration_s) - scene.time.start_s};
}

std::span<const std::uint8_t> bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void writeTo(const reference::TrajectoryTarget& target,
             const std::function<void(const reference::TextSink&)>& write) {
  if (target.isStream()) return write(writeOut);
  core::AtomicFile file(target.path);
  write([&](std::string_view text) { file.write(bytes(text)); });
  file.commit();
}

void checkTimesGiven(const TrajectoryOptions& options) {
  if (options.at.empty() == options.rate.empty())
    throw core::usageError("give either --at T1,T2,... or --rate HZ");
}

/// Returns the span of --at for --events; by default, the span of the film.
physics::TimeSpan spanOfEvents(const TrajectoryOptions& options, const scene::Scene& scene) {
  if (options.at.empty()) return {scene.time.start_s, stage::filmClock(scene).motionTime_s(scene.time.duration_s)};
  const reference::TrajectoryTimes times = listedTimes(options.at);
  return {times.earliest_s(), times.latest_s()};
}

void noteFarTimes(const scene::Scene& scene, const reference::TrajectoryTimes& times) {
  if (const std::string note = reference::accuracyNote(scene, times); !note.empty())
    writeErr("poinsot: note: " + note + "\n");
}

/// Checks the estimated size of the output. The estimate is 18 bytes per number: for the scenes of the gallery,
/// rows of 15 numbers have 271 to 303 bytes.
void checkOutput(const reference::TrajectoryTimes& times, std::size_t columns, const scene::Limits& limits) {
  constexpr double kNumber_bytes = 290. / 15;
  const double estimate = kNumber_bytes * static_cast<double>(columns) * static_cast<double>(times.count());
  const std::int64_t most = limits[scene::Limit::kOutput];
  if (estimate <= static_cast<double>(most)) return;
  throw core::limitError(fmt::format("{} rows are about {:.3g} GiB; a run may write {}; {}", times.count(),
                                     estimate / (1 << 30), limitText(scene::Limit::kOutput, most),
                                     howToRaise(scene::Limit::kOutput)));
}

int events(const TrajectoryOptions& options) {
  const auto target = reference::parseTrajectoryTarget(options.output);
  const scene::Scene scene = loadScene(options, granted(options));
  output::RunFiles files = enteredInputs(options, scene, options.force);
  files.writes(target.path, "-o", reference::eventsKind(target.format));
  const physics::TimeSpan span = spanOfEvents(options, scene);
  const auto motion = scene::makeMotion(scene, span.from_s, span.to_s);
  const std::string text = reference::eventsText(scene::sceneEvents(scene, *motion, stage::filmClock(scene), span),
                                                 target.format, scene.name);
  writeTo(target, [&](const reference::TextSink& sink) { sink(text); });
  return kDone;
}

int trajectory(const TrajectoryOptions& options) {
  if (options.events) return events(options);
  checkTimesGiven(options);
  const auto target = reference::parseTrajectoryTarget(options.output);
  const scene::Allowance allowance = granted(options);
  const scene::Scene scene = loadScene(options, allowance);
  reference::ChosenColumns columns = chosenColumns(options, scene);
  output::RunFiles files = enteredInputs(options, scene, options.force);
  files.writes(target.path, "-o", reference::trajectoryKind(target.format, columns.header()));
  const reference::TrajectoryTimes times = requestedTimes(options, scene);
  checkOutput(times, columns.columns().size(), allowance.limits);
  noteFarTimes(scene, times);
  process::watchInterrupts();
  const auto motion = scene::makeMotion(scene, times.earliest_s(), times.latest_s());
  columns.follow(*motion);
  writeTo(target, [&](const reference::TextSink& sink) {
    reference::writeTrajectory(*motion, columns, times, target.format, scene.name, sink);
  });
  return kDone;
}

}  // namespace

void addTrajectory(const Command& program) {
  auto options = std::make_shared<TrajectoryOptions>();
  const Command command =
      program.command("trajectory", "write the motion as numbers, as a reference to test an engine");
  addSceneOptions(command, *options);
  command.option("--at", options->at, "motion times in s, any order, such as 0,-3.5,1e9")
      .type("T1,T2,...")
      .repeats()
      .notEmpty();
  const Option rate =
      command
          .option("--rate", options->rate, "rows per second of motion, over the film's span, both ends included")
          .type("HZ")
          .notEmpty();
  const Option quantities =
      command
          .option(
              kQuantities, options->quantities,
              "columns after the time, instead of q, omega, L and T: quantities of plots, such as theta,phi,psi,E")
          .type("NAME1,NAME2,...")
          .repeats()
          .notEmpty();
  command
      .flag("--events", options->events,
            "write the events of the film instead of rows: flips, crossings of the separatrix, turning points of "
            "the nutation; with --at, those between the first and the last of its times")
      .excludes(rate)
      .excludes(quantities);
  command.option("-o,--output", options->output, "NAME.csv, NAME.json, or - for CSV on stdout (default)")
      .type("FILE")
      .notEmpty();
  command.flag("--force", options->force, "replace a file that this program did not write");
  command.footer(
      "Examples:\n"
      "  poinsot trajectory scenes/football.toml --rate 100 -o out/football.csv\n"
      "  poinsot trajectory scenes/football.toml --at=-3.5,0,1e6\n"
      "  poinsot trajectory scenes/tennis_racket.toml --events\n"
      "  poinsot trajectory scenes/football.toml --rate 50 --quantities theta,phi,psi,T\n"
      "docs/scene.md lists all quantities, with their units.");
  command.does({[options] { return trajectory(*options); }, options.get(),
                [options] {
                  return FileAccess{{options->scene}, options->assetRoots, {options->output}};
                }});
}

}  // namespace poinsot::cli
