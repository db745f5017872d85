// SPDX-License-Identifier: Apache-2.0
#include "trajectory.h"

#include <algorithm>

#include "app/trajectory_accuracy.h"
#include "app/trajectory_times.h"
#include "physics/motion.h"
#include "scene/make_motion.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;

/// n of some shape, to be filled in order.
class Rows {
 public:
  Rows(py::ssize_t n, const std::vector<py::ssize_t>& shapeOfOne) : array_(shape(n, shapeOfOne)) {
    next_ = array_.mutable_data();
  }
  template <class Values>
  void add(const Values& values) {
    next_ = std::copy(values.begin(), values.end(), next_);
  }
  void add(double value) { *next_++ = value; }
  py::array_t<double> take() { return std::move(array_); }

 private:
  static std::vector<py::ssize_t> shape(py::ssize_t n, const std::vector<py::ssize_t>& shapeOfOne) {
    std::vector<py::ssize_t> all{n};
    all.insert(all.end(), shapeOfOne.begin(), shapeOfOne.end());
    return all;
  }

  py::array_t<double> array_;
  double* next_ = nullptr;
};

}  // namespace

TrajectoryArrays trajectoryOf(const LoadedScene& loaded, const std::vector<double>& times_s) {
  const auto n = static_cast<py::ssize_t>(times_s.size());
  Rows q_WB(n, {4}), R_WB(n, {3, 3}), omega_B(n, {3}), omega_W(n, {3}), L_W(n, {3}), T(n, {});
  Rows rate_B(n, {3}), rate_W(n, {3});
  std::string note;
  if (n > 0) {
    const py::gil_scoped_release others;
    const app::TrajectoryTimes times(times_s);
    note = app::accuracyNote(loaded.scene(), times);
    const auto motion = scene::makeMotion(loaded.scene(), times.earliest_s(), times.latest_s());
    for (const double t_s : times_s) {
      const physics::RigidBodyState state = motion->at(t_s);
      q_WB.add(std::array{state.q_WB.w(), state.q_WB.x(), state.q_WB.y(), state.q_WB.z()});
      R_WB.add(
          Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(state.q_WB.toRotationMatrix()).reshaped<Eigen::RowMajor>());
      omega_B.add(state.omega_B);
      omega_W.add(state.omega_W);
      L_W.add(state.L_W);
      T.add(state.kineticEnergy);
      rate_B.add(physics::turningRate_B(*motion, state));
      rate_W.add(physics::turningRate_W(*motion, state));
    }
  }
  return {q_WB.take(),   R_WB.take(), omega_B.take(), omega_W.take(), L_W.take(), T.take(), rate_B.take(),
          rate_W.take(), note};
}

}  // namespace poinsot::python
