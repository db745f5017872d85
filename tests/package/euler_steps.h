// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

namespace poinsot {

using Vector = std::array<double, 3>;

/// Euler's equations without torque, a step of Runge and Kutta's fourth order.
Vector stepped(const Vector& I, const Vector& omega, double h);

/// Holds what tests/consumer/motion prints against the equations of motion integrated so.
void expectEulersMotion(const std::string& rows);

}  // namespace poinsot
