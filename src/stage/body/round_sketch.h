// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "physics/solid.h"
#include "stage/body/sketch.h"

/// Sketches of solids of revolution about the z axis. Rings and meridians make the rotation visible, and one
/// meridian is thicker than the others.
namespace poinsot::stage {

void add(const Sketch& sketch, const physics::Ellipsoid& solid);
void add(const Sketch& sketch, const physics::EllipsoidShell& solid);
void add(const Sketch& sketch, const physics::Sphere& solid);
void add(const Sketch& sketch, const physics::SphereShell& solid);
void add(const Sketch& sketch, const physics::Hemisphere& solid);
void add(const Sketch& sketch, const physics::Cylinder& solid);
void add(const Sketch& sketch, const physics::CylinderShell& solid);
void add(const Sketch& sketch, const physics::Disc& solid);
void add(const Sketch& sketch, const physics::Hoop& solid);
void add(const Sketch& sketch, const physics::Rod& solid);
void add(const Sketch& sketch, const physics::Cone& solid);
void add(const Sketch& sketch, const physics::ConeShell& solid);
void add(const Sketch& sketch, const physics::Torus& solid);
void add(const Sketch& sketch, const physics::TorusShell& solid);
void add(const Sketch& sketch, const physics::Capsule& solid);

/// Adds an elliptic cone that stands on its apex, the origin.
/// @param lengths  semi-axes of the base along x and y, and height along z
void addTop(const Sketch& sketch, const Eigen::Vector3d& lengths);

}  // namespace poinsot::stage
