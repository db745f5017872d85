// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/label_text.h"

namespace poinsot::scene {

const std::array<LabelDefault, kLabelCount>& labelDefaults() {
  static constexpr std::array<LabelDefault, kLabelCount> kDefaults{{
      {"L", "'$\\mathbf{L}$'", "'$\\vec L$'", "Label of the angular momentum."},
      {"omega", "'$\\boldsymbol{\\omega}$'", "'$\\vec\\omega$'", "Label of the angular velocity."},
      {"torque", "'$\\boldsymbol{\\tau}$'", "'$\\mathbf{N}$'", "Label of the torque."},
      {"e1", "'$\\hat{\\mathbf{e}}_1$'", "\"$x'$\"", "Label of the first principal axis."},
      {"e2", "'$\\hat{\\mathbf{e}}_2$'", "\"$y'$\"", "Label of the second principal axis."},
      {"e3", "'$\\hat{\\mathbf{e}}_3$'", "\"$z'$\"", "Label of the third principal axis."},
      {"x", "'$x$'", "'$X$'", "Label of the first axis of space."},
      {"y", "'$y$'", "'$Y$'", "Label of the second axis of space."},
      {"z", "'$z$'", "'up'", "Label of the third axis of space."},
      {"axis", "'$\\hat{\\mathbf{k}}$'", "'$\\vec n$'",
       "Label of the axis k, which show.main_axis and show.triad draw."},
      {"theta", "'$\\theta$'", "'$\\vartheta$'", "Label of the angle theta between the axis k and L."},
      {"height", "'$2T/L$'", "'$h$'", "Label of the height of the centre above the invariable plane."},
      {"plane", "'invariable plane'", "'plan invariable'", "Label of the invariable plane."},
      {"omega_p", "'$\\boldsymbol{\\omega}_p$'", "'$\\dot\\phi\\,\\hat L$'",
       "Label of the part of omega along L, which show.decomposition draws."},
      {"spin", "'$-\\Omega_p\\hat{\\mathbf{k}}$'", "'$\\dot\\psi\\,\\hat k$'",
       "Label of the part of omega along the axis, which show.decomposition draws."},
      {"omega_1", "'$\\omega_1$'", "'$\\omega_x$'",
       "Label of the first component of omega, which show.components and show.triad draw."},
      {"omega_2", "'$\\omega_2$'", "'$\\omega_y$'",
       "Label of the second component of omega, which show.components draws."},
      {"omega_3", "'$\\omega_3$'", "'$\\omega_z$'",
       "Label of the third component of omega, which show.components and show.triad draw."},
      {"R", "'$\\mathbf{R}$'", "'$\\vec R_\\mathrm{cm}$'",
       "Label of the position of the centre of mass, or of motion.flight.point, which show.flight draws."},
      {"V", "'$\\mathbf{V}$'", "'$\\mathbf{P}$'",
       "Label of the velocity of the centre of mass, or of motion.flight.point, which show.flight draws."},
      {"weight", "'$M\\mathbf{g}$'", "'$\\mathbf{F}$'", "Label of the force of gravity, which show.flight draws."},
      {"origin", "'$O$'", "'hand'", "Label of the origin, which show.flight draws."},
      {"K", "'$K$'", "'grip'", "Label of the point motion.flight.point, which show.flight draws."},
      {"orbital_L", "'$\\mathbf{R}\\times\\mathbf{P}$'", "'orbital'",
       "Label of the part R x P of the angular momentum about the origin, which show.total_L draws."},
      {"total_L", "'$\\mathbf{L}_\\mathrm{tot}$'", "'$\\mathbf{J}$'",
       "Label of the total angular momentum about the origin, which show.total_L draws."},
      {"torque_about_origin", "'$\\mathbf{R}\\times M\\mathbf{g}$'", "'$\\mathbf{N}$'",
       "Label of the torque of gravity about the origin, which show.total_L draws."},
      {"space_cone", "''", "'space cone'",
       "Label of the cone fixed in space, which show.cones draws. By default, none."},
      {"body_cone", "''", "'body cone'",
       "Label of the cone fixed in the body, which show.cones draws. By default, none."},
      {"i", "'$\\hat{\\mathbf{i}}$'", "'$\\vec e_x$'",
       "Label of the axis in the plane of L and k, which show.triad draws."},
      {"j", "'$\\hat{\\mathbf{j}}$'", "'$\\vec e_y$'",
       "Label of the axis perpendicular to L and k, which show.triad draws."},
      {"L_omega", "'$I_1\\boldsymbol{\\omega}$'", "'$I\\vec\\omega$'",
       "Label of the part of L along omega, which show.L_parts draws."},
      {"L_axis", "'$(I_3-I_1)\\,\\omega_3\\hat{\\mathbf{k}}$'", "'$\\Delta I\\,\\omega_3\\vec k$'",
       "Label of the part of L along the axis, which show.L_parts draws."},
  }};
  return kDefaults;
}

}  // namespace poinsot::scene
