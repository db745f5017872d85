// SPDX-License-Identifier: Apache-2.0
#include "stability.h"

#include "stage/stability_map.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
using Eigen::Vector3d;

py::array_t<double> arrayOf(const Vector3d& vector) { return py::array_t<double>(3, vector.data()); }

py::array_t<double> arrayOf(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = matrix;
  return py::array_t<double>({3, 3}, rows.data());
}

/// Returns two circles of unit vectors. Each circle is closed: its last point is its first.
py::array_t<double> circles(const physics::Separatrix& separatrix) {
  constexpr int kPoints = 241;
  py::array_t<double> circles({2, kPoints, 3});
  double* next = circles.mutable_data();
  for (const bool mirrored : {false, true})
    for (const Vector3d& point : separatrix.momentumCircle(1, kPoints, mirrored))
      next = std::copy(point.begin(), point.end(), next);
  return circles;
}

}  // namespace

StabilityNumbers stabilityOf(const LoadedScene& loaded, const Directions& directions_P) {
  const scene::Scene& scene = loaded.scene();
  const stage::StabilityMap map(scene);
  const stage::StabilityScale& scale = map.scale();
  const py::ssize_t n = directions_P.size() / 3;
  py::array_t<double> intervals_s(n);
  double* next = intervals_s.mutable_data();
  const double* direction = directions_P.data();
  {
    const py::gil_scoped_release others;
    for (py::ssize_t i = 0; i < n; ++i, direction += 3)
      *next++ = scale.time_s(Vector3d(direction[0], direction[1], direction[2]));
  }
  const physics::PrincipalAxes& axes = scene.body.axes;
  return {std::move(intervals_s),
          arrayOf(axes.moments().values()),
          arrayOf(axes.q_BP().toRotationMatrix()),
          arrayOf(axes.moments().angularMomentum(axes.toP(scene.motion.omega_B))),
          circles(scale.separatrix()),
          map.sceneTime_s(),
          scale.least_s(),
          scale.most_s(),
          scale.isLogarithmic()};
}

}  // namespace poinsot::python
