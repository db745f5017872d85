// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::app {

/// Tells a motion that is wrong from one that is written down otherwise: reads each row in the ways that are usual
/// elsewhere, too (order of a quaternion, its conjugate, axes of the body or of space turned once and for all,
/// omega along the other axes or in other units), and finds which way fits.
class ConventionSearch {
 public:
  /// q_WB: unit quaternions; theirs as it was read.
  void addAttitude(const Eigen::Quaterniond& ours, const Eigen::Quaterniond& theirs);

  /// rad/s; `theirs` as it was read from the columns of one frame, `other`: ours along the other frame's axes.
  void addOmega(const Eigen::Vector3d& ours, const Eigen::Vector3d& other, const Eigen::Vector3d& theirs);

  /// What to look for, in words; nothing where they fit as they are, or in no way by far.
  std::vector<std::string> hints() const;

 private:
  enum Reading { kAsRead, kScalarLast, kConjugate, kScalarLastConjugate, kBodyTurned, kSpaceTurned, kReadings };

  /// Mean of squares.
  struct Misfit {
    double sum = 0;
    std::size_t count = 0;

    void add(double squared);
    double rms() const;
    bool muchLessThan(const Misfit& asRead) const;
  };

  Eigen::Quaterniond read(Reading reading, const Eigen::Quaterniond& theirs) const;
  std::string attitudeHint() const;
  std::string omegaHint() const;
  static std::string turnHint(std::string_view axes, const Eigen::Quaterniond& turn);

  std::optional<Eigen::Quaterniond> bodyTurn_, spaceTurn_;  ///< that make the first row fit
  std::array<Misfit, kReadings> attitude_;
  Misfit omega_, omegaInOtherFrame_, omegaInDegrees_, omegaInRpm_;
};

}  // namespace poinsot::app
