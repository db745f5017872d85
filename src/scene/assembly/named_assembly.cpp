// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include "scene/assembly/steady_precession.h"
#include "scene/keys/unknown_names.h"

namespace poinsot::scene {
namespace {

std::vector<std::string> givenWays(const std::string& path, const Findings& findings) {
  std::vector<std::string> given;
  for (const char* way : {"components", "position_of", "velocity_of"})
    if (findings.has(path + "." + way)) given.push_back(path + "." + way);
  return given;
}

/// Returns advice for a vector without components: the arrow of its own, if its name is that of one.
std::string arrowAdvice(const std::string& name, const Findings& findings) {
  const std::string figure = figureOf(name);
  if (figure.empty()) return "give one of them";
  return fmt::format("{0} has an arrow of its own. For example, in place of this [[vector]], {1}\n    {0} = true",
                     figure, findings.hasTable("show") ? "in [show]:" : "at the end of the file:\n    [show]");
}

void checkWays(const std::string& path, const VectorDraft& draft, Findings& findings) {
  const std::vector<std::string> given = givenWays(path, findings);
  if (given.empty())
    return findings.refuseMissing(
        path + ".components", path + ".components",
        "a vector needs components, position_of or velocity_of; " + arrowAdvice(draft.name, findings));
  for (std::size_t i = 1; i < given.size(); ++i)
    findings.refuse(given[i], fmt::format("cannot be combined with {}; give one of them", given[0]));
  if (draft.components && draft.components->isZero(0))
    findings.refuse(path + ".components", "must not all be zero: the vector would have no direction");
  if (findings.has(path + ".frame") && !findings.has(path + ".components"))
    findings.refuse(path + ".frame", "only components have a frame; leave it out");
}

void checkAxes(const std::string& path, const VectorDraft& draft, const std::optional<Rest>& rest,
               const Scene& scene, Findings& findings) {
  const bool startKnown = rest || !scene.motion.omega_B.isZero(0);
  if (draft.frame != VectorFrame::kPrecession || !startKnown) return;
  if (const std::string why = withoutTriad(scene, rest); !why.empty())
    findings.refuse(path + ".frame", fmt::format("\"precession\" does not exist: {}", why));
}

NamedVector vectorOf(const VectorDraft& draft) {
  NamedVector vector{.what = FixedVector(), .name = draft.name, .scale = draft.scale, .color = draft.color};
  if (draft.position)
    vector.what = PositionVector{*draft.position};
  else if (draft.velocity)
    vector.what = VelocityVector{*draft.velocity};
  else if (draft.components)
    vector.what = FixedVector{*draft.components, draft.frame};
  return vector;
}

void checkBetween(const std::string& path, const AngleDraft& draft, Findings& findings) {
  if (!findings.has(path + ".between"))
    return findings.refuse(path + ".between", "is required: two directions, such as [\"L\", \"omega\"]");
  if (!findings.failed(path + ".between") && draft.between.size() != 2)
    findings.refuse(path + ".between",
                    fmt::format("an angle lies between two directions, got {}", draft.between.size()));
}

NamedAngle angleOf(const AngleDraft& draft) {
  NamedAngle angle{.name = draft.name, .scale = draft.scale};
  if (draft.between.size() != 2) return angle;
  angle.from = draft.between[0];
  angle.to = draft.between[1];
  return angle;
}

template <class T>
T elementOr(const std::vector<T>& given, std::size_t i) {
  return i < given.size() ? given[i] : T();
}

}  // namespace

void assembleNamed(const Draft& draft, const std::optional<Rest>& rest, Findings& findings, Scene& scene) {
  for (std::size_t i = 0; i < findings.count("vector"); ++i) {
    const VectorDraft given = elementOr(draft.vectors, i);
    const std::string path = fmt::format("vector[{}]", i);
    checkWays(path, given, findings);
    checkAxes(path, given, rest, scene, findings);
    if (given.frame == VectorFrame::kOwn && !findings.hasTable("body.own_axes"))
      findings.refuse(path + ".frame", "\"own\" needs axes of one's own; give [body.own_axes]");
    scene.vectors.push_back(vectorOf(given));
  }
  for (std::size_t i = 0; i < findings.count("angle"); ++i) {
    const AngleDraft given = elementOr(draft.angles, i);
    checkBetween(fmt::format("angle[{}]", i), given, findings);
    scene.angles.push_back(angleOf(given));
  }
}

}  // namespace poinsot::scene
