// SPDX-License-Identifier: Apache-2.0
#include "scene/style_colors.h"

namespace poinsot::scene {

const std::array<ColorKey, kColorMeanings>& colorKeys() {
  static constexpr std::array<ColorKey, kColorMeanings> kKeys = {{
      {"paper", "\"#FFFDF5\"", "Background of the picture."},
      {"ink", "\"#202020\"", "Titles, angles and everything without a colour of its own."},
      {"quiet_ink", "\"#606060\"",
       "Colour of subtitles, notes and the frames of plots. The default is a paler `ink`."},
      {"L", "\"#004C8C\"", "Angular momentum, its arrow and labels."},
      {"plane", "\"#8FB8DE\"", "The invariable plane. By default, a tint of `L`."},
      {"omega", "\"#B03A2E\"", "Angular velocity, its arrow and labels."},
      {"polhode", "\"#B03A2E\"", "Colour of the path of omega in the body. The default is the colour `omega`."},
      {"herpolhode", "\"#7B241C\"", "Colour of the path of omega in space. The default is the colour `omega`."},
      {"ellipsoid", "\"#F0B27A\"", "Poinsot's ellipsoid and the energy ellipsoid."},
      {"graticule", "\"#A04000\"", "Lines on the ellipsoid. By default, a shade of `ellipsoid`."},
      {"omega_parts", "\"#6E2C00\"",
       "Colour of the components of omega, along the principal axes or as precession and spin."},
      {"separatrix", "\"#7D3C98\"", "The polhode between the two kinds of motion."},
      {"body", "\"#76B7A0\"", "The body itself. Its edges are a shade of this colour."},
      {"mark", "\"#145A32\"",
       "Marks on the body, such as the camera of a phone. By default, a dark shade of `body`."},
      {"axis", "\"#145A32\"", "Principal axes and paths of points of the body."},
      {"space_cone", "\"#004C8C\"", "The cone fixed in space. By default, the colour `L`."},
      {"body_cone", "\"#145A32\"", "The cone fixed in the body. By default, the colour `axis`."},
      {"torque", "\"#512E5F\"", "Torque on the body."},
      {"vector", "\"#707070\"", "The vectors of [[vector]]."},
      {"support", "\"#B0B0B0\"", "Space axes, stands, and rods that have no mass."},
  }};
  return kKeys;
}

}  // namespace poinsot::scene
