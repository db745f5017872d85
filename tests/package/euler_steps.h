// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

namespace poinsot {

using Vector = std::array<double, 3>;

/// Returns omega after a time step `h` of Euler's equations without torque, by Runge and Kutta's method of fourth
/// order.
Vector stepped(const Vector& I, const Vector& omega, double h);

/// Compares the output of tests/consumer/motion with the equations of motion, integrated by stepped().
void expectEulersMotion(const std::string& rows);

}  // namespace poinsot
