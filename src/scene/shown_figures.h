// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// Options that all drawn things have. `scale` is a factor on the default size in the picture.
struct Drawn {
  bool visible = true;
  double scale = 1;
};

/// Drawn thing that is hidden by default.
struct Extra : Drawn {
  Extra() : Drawn{false, 1} {}
};

/// Optional things in a picture. The body, its vectors and Poinsot's construction are not among them.
struct ShownFigures {
  struct : Extra {
    double opacity = 0;
  } cones;              ///< body cone and space cone of a free body
  Extra mainAxis;       ///< axis k of QuantityBasis
  Extra theta;          ///< angle between k and L
  Extra decomposition;  ///< parallelogram omega = omega_p - Omega_p k
  Extra LParts;         ///< L = I1 omega + (I3 - I1) omega_3 k, head to tail
  Extra components;     ///< components of omega along the principal axes
  struct : Extra {
    bool components = true;  ///< whether omega_1 and omega_3, along i and k, are drawn too
  } triad;                   ///< axes i, j, k of a symmetric top, with i in the plane of L and k
  Extra spaceAxes;
  Extra torque;
  struct : Extra {
    double opacity = 0;
  } planeOfL;  ///< plane through L and omega, which contains the axis of a symmetric body
  struct : Extra {
    std::vector<double> times_s;  ///< film times of the poses; if empty, `count` times spread over the film
    int count = 0;
    double strength = 0;  ///< strength of the colours, from 0 (as the paper) to 1 (as the body)
    Eigen::Vector3d step = Eigen::Vector3d::Zero();  ///< shift between poses, in the body's longest extents
  } ghosts;                                          ///< copies of the body in its poses at other times
  struct : Extra {
    int count = 0;  ///< number of curves between the separatrix and each extreme axis
  } polhodes;       ///< family of polhodes on the energy ellipsoid
  struct : Extra {
    double opacity = 0;
    int count = 0;      ///< number of curves, counted as in polhodes
    bool area = false;  ///< whether the area of the sphere that the polhode encloses is filled
  } binet;              ///< momentum sphere and energy ellipsoid in the space of L
  struct : Extra {
    std::optional<Eigen::Vector3d> point_B;  ///< point of the body, m; nullopt for a point on k
    double opacity = 0;                      ///< opacity of the sphere on which the path lies
    bool future = true;                      ///< whether the path after the current instant is drawn too, faintly
  } trace;                                   ///< path of a point of the body
  struct {
    bool visible = true;
    std::optional<double> scale;  ///< scale of the path; nullopt for a scale at which the body is visible
    bool position = true, velocity = true, weight = false;
  } flight;  ///< path of a thrown body through the views of space
  struct : Drawn {
    bool arms = false;  ///< whether the position r of each point is drawn too
  } forces;             ///< forces at points of the body, while they act
  Drawn table;          ///< table on which a cone rolls, with the line of contact
  struct : Extra {
    bool torque = false;  ///< whether the torque about the origin is drawn
  } totalL;               ///< angular momentum of a thrown body about the origin, and its parts
};

}  // namespace poinsot::scene
