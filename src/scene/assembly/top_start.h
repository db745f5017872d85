// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "scene/keys/draft.h"
#include "scene/keys/findings.h"
#include "scene/scene.h"

namespace poinsot::scene {

/// Returns whether the scene gives the start as a precession or a nutation of a heavy top.
bool isTopStart(const StartDraft& start);

/// Returns omega_B, rad/s, of a heavy top that starts with a precession or a nutation. Returns nullopt after it
/// reported to `findings` why the body has no such motion.
/// @param motion  has the forcing and the attitude
/// @param axis_B  axis about which the top spins, of unit length; nullopt if the scene names none
std::optional<Eigen::Vector3d> topOmega(const StartDraft& start, const Body& body, const Motion& motion,
                                        const std::optional<Eigen::Vector3d>& axis_B, Findings& findings);

}  // namespace poinsot::scene
