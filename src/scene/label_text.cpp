// SPDX-License-Identifier: Apache-2.0
#include "scene/label_text.h"

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
  }};
  return kDefaults;
}

}  // namespace poinsot::scene
