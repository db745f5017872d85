// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// A drawn thing's common options; `scale` multiplies the default size in the picture.
struct Drawn {
  bool visible = true;
  double scale = 1;
};

/// A drawn thing that is not there unless it is asked for.
struct Extra : Drawn {
  Extra() : Drawn{false, 1} {}
};

/// What a picture may show besides body, vectors and Poinsot's construction.
struct ShownFigures {
  struct : Extra {
    double opacity = 0;
  } cones;              ///< body cone and space cone of a symmetric top
  Extra mainAxis;       ///< k
  Extra theta;          ///< the angle between k and L
  Extra decomposition;  ///< the parallelogram omega = omega_p - Omega_p k
  Extra components;     ///< of omega along the principal axes
  Extra spaceAxes;
  Extra torque;
  struct : Extra {
    double opacity = 0;
  } planeOfL;  ///< through L and omega, and the axis of a symmetric body
  struct : Extra {
    std::vector<double> times_s;  ///< of film; empty: `count` of them over the film
    int count = 0;
    double strength = 0;                             ///< of their colours against the paper, 0 to 1
    Eigen::Vector3d step = Eigen::Vector3d::Zero();  ///< from one to the next, in the body's longest extents
  } ghosts;                                          ///< poses at other times
  struct : Extra {
    int count = 0;  ///< curves between the separatrix and each extreme axis
  } polhodes;       ///< a family on the energy ellipsoid
  struct : Extra {
    double opacity = 0;
    int count = 0;  ///< as of polhodes
  } binet;          ///< momentum sphere and energy ellipsoid, in the space of L
  struct : Extra {
    std::optional<Eigen::Vector3d> point_B;  ///< m; none: a point on k
    double opacity = 0;                      ///< of the sphere
    bool future = true;                      ///< the part not yet travelled, faint
  } trace;                                   ///< path of a point of the body
  struct {
    bool visible = true;
    std::optional<double> scale;  ///< of lengths on the path beside the body's; none: as lets the body be seen
    bool position = true, velocity = true, weight = false;
  } flight;  ///< of a thrown body: the body moves along in the views at rest in space
  struct : Extra {
    bool torque = false;  ///< about the origin
  } totalL;               ///< of a thrown body about the origin, with its parts
};

}  // namespace poinsot::scene
