// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/assemble.h"

#include <fmt/format.h>

#include "core/frame_clock.h"
#include "scene/assembly/parts.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

constexpr const char* kNothing =
    "a body and a start are required, for example:\n"
    "    schema = 1\n"
    "    [body]\n"
    "    principal_moments = [1.0, 2.0, 2.5]\n"
    "    [motion]\n"
    "    omega_body = [0.01, 3.0, 0.0]";

std::optional<Rest> bodyAndMotion(const Draft& draft, Findings& findings, const SceneFolder& folder,
                                  Scene& scene) {
  const std::optional<Body> body = assembleBody(draft, findings, folder);
  assembleForcing(draft, body ? &*body : nullptr, findings, folder, scene.motion);
  scene.motion.flight = assembleFlight(draft, findings);
  std::optional<Rest> rest;
  if (findings.hasTable("motion.rolling"))
    assembleRolling(draft, body ? &*body : nullptr, findings, scene.motion);
  else
    rest = assembleStart(draft, body ? &*body : nullptr, findings, scene.motion);
  if (body) scene.body = *body;
  if (body) throwByPoint(draft, scene);
  return rest;
}

/// Checks the number of frames against the limit. Frame k is in the film if k/fps < duration.
void checkFrames(const Time& time, Findings& findings) {
  const std::int64_t count = core::frameCount(time.duration_s, time.fps);
  const std::int64_t most = findings.limits()[Limit::kFrames];
  if (count > most)
    findings.refuse(
        findings.has("time.duration") ? "time.duration" : "time.fps",
        fmt::format("{} s at {} frames per second are {} frames; a film may have at most {}; {}", time.duration_s,
                    core::toString(time.fps), count, most, howToRaise(Limit::kFrames)));
}

Output assembleOutput(const Draft& draft) {
  const QualityPreset& preset = qualityPresets()[static_cast<std::size_t>(draft.quality)];
  const Eigen::Vector2i size = draft.size_px.value_or(Eigen::Vector2i(preset.width, preset.height));
  const auto word = [](std::span<const std::string_view> words, int i) {
    return std::string(words[static_cast<std::size_t>(i)]);
  };
  return {size[0],
          size[1],
          draft.crf.value_or(preset.crf),
          draft.codec ? word(codecWords(), *draft.codec) : "",
          word(chromaWords(), draft.chroma),
          word(effortWords(), draft.effort),
          draft.scene.output.colors,
          draft.scene.output.language};
}

}  // namespace

Scene assemble(Draft draft, Findings& findings, const SceneFolder& folder) {
  leaveOutOfFlight(findings, draft.scene.show);
  askForShown(draft, findings);
  Scene scene = draft.scene;
  std::optional<Rest> rest;
  const auto lacks = [&](const char* table) { return !findings.hasBelow(table) && !findings.isMeantBelow(table); };
  if (lacks("body") && lacks("motion") && findings.count("body.part") == 0)
    findings.refuseEmpty(kNothing);
  else
    rest = bodyAndMotion(draft, findings, folder, scene);
  assembleDrawnShape(draft, findings, folder, scene.show);
  assembleMarks(draft, findings, folder, scene);
  PanelGrid grid(findings);
  assembleViews(draft, rest, findings, grid, scene);
  assemblePlots(draft, findings, grid, scene);
  assembleNotes(draft, findings, scene);
  assembleNamed(draft, rest, findings, scene);
  assembleTimeline(draft, findings, scene);
  finishStyle(scene.style);
  checkFrames(scene.time, findings);
  if (draft.loop) scene.time.loop.emplace();
  scene.output = assembleOutput(draft);
  return scene;
}

}  // namespace poinsot::scene
