// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"
#include "physics/motion.h"
#include "scene/scene.h"
#include "scene/state_quantity.h"

namespace poinsot::reference {

struct TrajectoryColumn {
  std::string_view name, unit;
};

/// Columns of a trajectory, in order: time; q, which maps components along the scene's body axes B to components
/// along the inertial axes W; angular velocity I^-1 m in B and in W; angular momentum; rotational energy. With
/// dissipation, the angular velocity of the attitude follows, in B and in W, because it then differs from omega.
inline constexpr std::array<TrajectoryColumn, 21> kTrajectoryColumns{{{"t", "s"},
                                                                      {"q_w", "1"},
                                                                      {"q_x", "1"},
                                                                      {"q_y", "1"},
                                                                      {"q_z", "1"},
                                                                      {"omega_B_x", "rad/s"},
                                                                      {"omega_B_y", "rad/s"},
                                                                      {"omega_B_z", "rad/s"},
                                                                      {"omega_W_x", "rad/s"},
                                                                      {"omega_W_y", "rad/s"},
                                                                      {"omega_W_z", "rad/s"},
                                                                      {"L_W_x", "kg m^2/s"},
                                                                      {"L_W_y", "kg m^2/s"},
                                                                      {"L_W_z", "kg m^2/s"},
                                                                      {"T", "J"},
                                                                      {"rate_B_x", "rad/s"},
                                                                      {"rate_B_y", "rad/s"},
                                                                      {"rate_B_z", "rad/s"},
                                                                      {"rate_W_x", "rad/s"},
                                                                      {"rate_W_y", "rad/s"},
                                                                      {"rate_W_z", "rad/s"}}};

/// Index in kTrajectoryColumns of the first column of each quantity.
enum TrajectoryPlace : std::size_t {
  kTimeAt = 0,
  kQAt = 1,
  kOmegaBAt = 5,
  kOmegaWAt = 8,
  kLWAt = 11,
  kEnergyAt = 14,
  kRateBAt = 15,
  kRateWAt = 18
};

using TrajectoryRow = std::array<double, kTrajectoryColumns.size()>;

TrajectoryRow trajectoryRow(const physics::Motion& motion, const physics::RigidBodyState& state);

/// Returns the columns of a trajectory. Without dissipation (alpha = 0), omits the angular velocity of the
/// attitude, because it equals omega.
/// @param alpha  dissipation, s/(kg·m²)
constexpr std::span<const TrajectoryColumn> trajectoryColumns(double alpha) {
  return std::span(kTrajectoryColumns).first(alpha > 0 ? kTrajectoryColumns.size() : std::size_t{kRateBAt});
}

/// Choice of columns for a trajectory, and the computation of their values. The time is always the first column.
class ChosenColumns {
 public:
  /// Chooses trajectoryColumns(). @param alpha  dissipation, s/(kg·m²)
  explicit ChosenColumns(double alpha);

  /// Chooses the time and the named columns, in the order of the names. A name is that of a quantity of plots
  /// (scene/state_quantity.h) or of a column of kTrajectoryColumns. Lengths, times and angles are in SI units and
  /// radians. The name "t" has no effect, because the time is the first column.
  /// @param option  option with the names, for messages, such as "--quantities"
  /// @throws core::Error(kUsage) for a name that is unknown, that is given twice, or that needs a flight or a mass
  /// that the scene does not have
  ChosenColumns(const scene::Scene& scene, const std::vector<std::string>& names, std::string_view option);

  /// Prepares for states of this motion. Required before evaluate() if forces at points act on a thrown body.
  void follow(const physics::Motion& motion) {
    if (basis_) basis_->follow(motion);
  }

  std::span<const TrajectoryColumn> columns() const { return columns_; }
  /// Returns the names of the columns, separated by commas.
  std::string header() const;
  /// Replaces `values` by the values of the columns. A value that does not exist, such as the precession of a body
  /// that spins about L itself, is NaN.
  void evaluate(const physics::Motion& motion, const physics::RigidBodyState& state,
                std::vector<double>& values) const;

 private:
  /// Origin of a column: a place in kTrajectoryColumns, or an index into scene::stateQuantities().
  struct Origin {
    std::size_t place = 0;
    std::optional<int> quantity;
  };

  static std::optional<Origin> originOf(const std::string& name);
  void add(const Origin& origin);

  std::vector<Origin> origins_;
  std::vector<TrajectoryColumn> columns_;
  std::optional<scene::QuantityBasis> basis_;
};

/// Returns the words of a list that is separated by commas, without blanks around them. An empty text has one
/// empty word.
std::vector<std::string> namesIn(std::string_view list);

static_assert(core::laidOut<TrajectoryColumn, 32>());

}  // namespace poinsot::reference
