// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/label_text.h"

namespace poinsot::scene {

const std::array<LabelDefault, kLabelCount>& labelDefaults() {
  static constexpr std::array<LabelDefault, kLabelCount> kDefaults{{
      {"L", "'$\\mathbf{L}$'", "'$\\vec L$'", "At the angular momentum."},
      {"omega", "'$\\boldsymbol{\\omega}$'", "'$\\vec\\omega$'", "At the angular velocity."},
      {"torque", "'$\\boldsymbol{\\tau}$'", "'$\\mathbf{N}$'", "At the torque."},
      {"e1", "'$\\hat{\\mathbf{e}}_1$'", "\"$x'$\"", "At the first principal axis."},
      {"e2", "'$\\hat{\\mathbf{e}}_2$'", "\"$y'$\"", "At the second principal axis."},
      {"e3", "'$\\hat{\\mathbf{e}}_3$'", "\"$z'$\"", "At the third principal axis."},
      {"x", "'$x$'", "'$X$'", "At the first axis of space."},
      {"y", "'$y$'", "'$Y$'", "At the second axis of space."},
      {"z", "'$z$'", "'up'", "At the third axis of space."},
      {"axis", "'$\\hat{\\mathbf{k}}$'", "'$\\vec n$'", "At the axis that show.main_axis draws."},
      {"theta", "'$\\theta$'", "'$\\vartheta$'", "At the angle between that axis and L."},
      {"height", "'$2T/L$'", "'$h$'", "At the height of the centre above the invariable plane."},
      {"plane", "'invariable plane'", "'plan invariable'", "Beside the plane."},
      {"omega_p", "'$\\boldsymbol{\\omega}_p$'", "'$\\dot\\phi\\,\\hat L$'",
       "At the part of omega along L, of show.decomposition."},
      {"spin", "'$-\\Omega_p\\hat{\\mathbf{k}}$'", "'$\\dot\\psi\\,\\hat k$'",
       "At the part of omega along the axis, of show.decomposition."},
      {"omega_1", "'$\\omega_1$'", "'$\\omega_x$'", "At the first component of omega, of show.components."},
      {"omega_2", "'$\\omega_2$'", "'$\\omega_y$'", "At the second component of omega."},
      {"omega_3", "'$\\omega_3$'", "'$\\omega_z$'", "At the third component of omega."},
      {"R", "'$\\mathbf{R}$'", "'$\\vec R_\\mathrm{cm}$'",
       "At the position of the centre of mass, of show.flight."},
      {"V", "'$\\mathbf{V}$'", "'$\\mathbf{P}$'", "At its velocity."},
      {"weight", "'$M\\mathbf{g}$'", "'$\\mathbf{F}$'", "At the force of gravity."},
      {"origin", "'$O$'", "'hand'", "At the origin."},
      {"orbital_L", "'$\\mathbf{R}\\times\\mathbf{P}$'", "'orbital'",
       "At the part R x P of the angular momentum about the origin, of show.total_L."},
      {"total_L", "'$\\mathbf{L}_\\mathrm{tot}$'", "'$\\mathbf{J}$'", "At the whole of it."},
      {"torque_about_origin", "'$\\mathbf{R}\\times M\\mathbf{g}$'", "'$\\mathbf{N}$'",
       "At the torque of gravity about the origin."},
  }};
  return kDefaults;
}

}  // namespace poinsot::scene
