// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "physics/principal_moments.h"

namespace poinsot::physics {

// Principal moments, in kg·m², about the centre of mass, of homogeneous bodies. Masses in kg, lengths in m.
// Formulas: Landau & Lifshitz, Mechanics, section 32, problem 2, unless said; each throws core::Error(kPhysics)
// for a mass or length that is not positive and finite.

/// Box with edges along the axes: I_x = M (b² + c²)/12 and cyclic, for edges a, b, c.
PrincipalMoments solidBoxMoments(double mass_kg, const Eigen::Vector3d& edges_m);

/// Ellipsoid: I_x = M (b² + c²)/5 and cyclic, for semi-axes a, b, c.
PrincipalMoments solidEllipsoidMoments(double mass_kg, const Eigen::Vector3d& semiAxes_m);

/// Cylinder about z: I_x = I_y = M (3r² + h²)/12, I_z = M r²/2.
PrincipalMoments solidCylinderMoments(double mass_kg, double radius_m, double height_m);

/// Racket: a hoop of radius R = width/2 in the xy plane and a slender handle of length l = length - width from its
/// rim along x, masses m_h : m_l = 17 : 16 (0.17 kg and 0.16 kg, a tennis racket's). With d = R + l/2 between
/// their centres and mu = m_h m_l/(m_h + m_l):
///   I_x = m_h R²/2 (about the handle),  I_y = m_h R²/2 + m_l l²/12 + mu d²,  I_z = I_x + I_y  (a lamina)
/// Source: hoop and rod as above, displaced by the theorem of the lecture's eq (14).
/// @throws core::Error(kPhysics) also if width_m >= length_m.
PrincipalMoments racketMoments(double mass_kg, double length_m, double width_m);

}  // namespace poinsot::physics
