// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// Common options of a drawn thing. `scale` multiplies the default size in the picture.
struct Drawn {
  bool visible = true;
  double scale = 1;
};

/// Drawn thing that is hidden by default.
struct Extra : Drawn {
  Extra() : Drawn{false, 1} {}
};

/// Optional figures in a picture, besides body, vectors and Poinsot's construction.
struct ShownFigures {
  struct : Extra {
    double opacity = 0;
  } cones;              ///< body cone and space cone of a symmetric top
  Extra mainAxis;       ///< axis k of QuantityBasis
  Extra theta;          ///< angle between k and L
  Extra decomposition;  ///< parallelogram omega = omega_p - Omega_p k
  Extra components;     ///< components of omega along the principal axes
  Extra spaceAxes;
  Extra torque;
  struct : Extra {
    double opacity = 0;
  } planeOfL;  ///< plane through L and omega, which contains the axis of a symmetric body
  struct : Extra {
    std::vector<double> times_s;  ///< film times; empty: `count` times spread over the film
    int count = 0;
    double strength = 0;                             ///< strength of their colours, from 0 (paper) to 1 (body)
    Eigen::Vector3d step = Eigen::Vector3d::Zero();  ///< shift between neighbours, in the body's longest extents
  } ghosts;                                          ///< poses of the body at other times
  struct : Extra {
    int count = 0;  ///< curves between the separatrix and each extreme axis
  } polhodes;       ///< family of polhodes on the energy ellipsoid
  struct : Extra {
    double opacity = 0;
    int count = 0;  ///< number of curves, as in polhodes
  } binet;          ///< momentum sphere and energy ellipsoid in the space of L
  struct : Extra {
    std::optional<Eigen::Vector3d> point_B;  ///< m; nullopt: a point on k
    double opacity = 0;                      ///< opacity of the sphere
    bool future = true;                      ///< also draws the part not yet travelled, faintly
  } trace;                                   ///< path of a point of the body
  struct {
    bool visible = true;
    std::optional<double> scale;  ///< scale of the path relative to the body; nullopt: keeps the body visible
    bool position = true, velocity = true, weight = false;
  } flight;  ///< thrown body, which moves through the views at rest in space
  struct : Extra {
    bool torque = false;  ///< torque about the origin
  } totalL;               ///< angular momentum of a thrown body about the origin, with its parts
};

}  // namespace poinsot::scene
