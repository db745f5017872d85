// SPDX-License-Identifier: Apache-2.0
#include "trajectory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/error.h"
#include "physics/motion.h"
#include "reference/events.h"
#include "reference/trajectory_columns.h"
#include "reference/trajectory_times.h"
#include "scene/motion/scene_events.h"
#include "signals.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
using Shape = std::vector<py::ssize_t>;

class Rows {
 public:
  Rows(Shape shape, const Shape& shapeOfOne) {
    shape.insert(shape.end(), shapeOfOne.begin(), shapeOfOne.end());
    array_ = Doubles(shape);
    next_ = array_.mutable_data();
  }
  template <class Values>
  void add(const Values& values) {
    next_ = std::copy(values.begin(), values.end(), next_);
  }
  void add(double value) { *next_++ = value; }
  Doubles take() { return std::move(array_); }

 private:
  Doubles array_;
  double* next_ = nullptr;
};

/// Returns "times[1, 2]: " for the k-th time of an array; empty for a single time.
std::string placeOf(std::size_t k, const Shape& shape) {
  if (shape.empty()) return "";
  std::vector<std::size_t> index(shape.size());
  for (std::size_t axis = shape.size(); axis-- > 0; k /= static_cast<std::size_t>(shape[axis]))
    index[axis] = k % static_cast<std::size_t>(shape[axis]);
  return fmt::format("times[{}]: ", fmt::join(index, ", "));
}

template <class Action, class Origin>
auto naming(const Action& action, const Origin& origin) {
  try {
    return action();
  } catch (const core::Error& error) {
    throw core::Error(error.kind(), origin() + error.message());
  }
}

std::shared_ptr<const physics::Motion> motionFor(const LoadedScene& loaded, std::span<const double> times_s,
                                                 const Shape& shape,
                                                 const std::optional<std::pair<double, double>>& span_s) {
  const auto [earliest, latest] = std::ranges::minmax(times_s);
  const std::pair<double, double> ends_s = span_s.value_or(std::pair(earliest, latest));
  const auto origin = [&] {
    if (span_s) return fmt::format("span=({}, {}): ", span_s->first, span_s->second);
    const auto farthest = std::ranges::max_element(times_s, {}, [](double t_s) { return std::abs(t_s); });
    return placeOf(static_cast<std::size_t>(farthest - times_s.begin()), shape) +
           fmt::format("t = {} s: ", *farthest);
  };
  return naming([&] { return loaded.motionOver(ends_s.first, ends_s.second); }, origin);
}

class Table {
 public:
  Table(const Shape& shape, const reference::ChosenColumns& chosen)
      : chosen_(chosen),
        q_WB_(shape, {4}),
        R_WB_(shape, {3, 3}),
        omega_B_(shape, {3}),
        omega_W_(shape, {3}),
        L_W_(shape, {3}),
        T_(shape, {}),
        rate_B_(shape, {3}),
        rate_W_(shape, {3}) {
    for (std::size_t i = 1; i < chosen.columns().size(); ++i) quantities_.emplace_back(shape, Shape{});
  }

  void add(const physics::Motion& motion, const physics::RigidBodyState& state) {
    using RowByRow = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    q_WB_.add(std::array{state.q_WB.w(), state.q_WB.x(), state.q_WB.y(), state.q_WB.z()});
    R_WB_.add(RowByRow(state.q_WB.toRotationMatrix()).reshaped<Eigen::RowMajor>());
    omega_B_.add(state.omega_B);
    omega_W_.add(state.omega_W);
    L_W_.add(state.L_W);
    T_.add(state.kineticEnergy);
    rate_B_.add(physics::turningRate_B(motion, state));
    rate_W_.add(physics::turningRate_W(motion, state));
    if (quantities_.empty()) return;
    chosen_.evaluate(motion, state, row_);
    for (std::size_t i = 0; i < quantities_.size(); ++i) quantities_[i].add(row_[i + 1]);
  }

  TrajectoryArrays take(std::string note) {
    std::vector<Doubles> quantities;
    for (Rows& rows : quantities_) quantities.push_back(rows.take());
    return {q_WB_.take(), R_WB_.take(),   omega_B_.take(), omega_W_.take(),       L_W_.take(),
            T_.take(),    rate_B_.take(), rate_W_.take(),  std::move(quantities), std::move(note)};
  }

 private:
  const reference::ChosenColumns& chosen_;
  Rows q_WB_, R_WB_, omega_B_, omega_W_, L_W_, T_, rate_B_, rate_W_;
  std::vector<Rows> quantities_;
  std::vector<double> row_;
};

}  // namespace

TrajectoryArrays trajectoryOf(const LoadedScene& loaded, const Doubles& times,
                              const std::optional<std::pair<double, double>>& span_s,
                              const std::vector<std::string>& quantities) {
  const Shape shape(times.shape(), times.shape() + times.ndim());
  const std::span<const double> times_s(times.data(), static_cast<std::size_t>(times.size()));
  reference::ChosenColumns chosen = [&] {
    const WithoutGil others;
    return reference::ChosenColumns(loaded.scene(), quantities, "quantities");
  }();
  Table table(shape, chosen);
  std::string note;
  if (!times_s.empty()) {
    const WithoutGil others;
    const auto [earliest, latest] = std::ranges::minmax(times_s);
    note = reference::accuracyNote(loaded.scene(), reference::TrajectoryTimes({earliest, latest}));
    const auto motion = motionFor(loaded, times_s, shape, span_s);
    chosen.follow(*motion);
    for (std::size_t k = 0; k < times_s.size(); ++k) {
      core::checkInterruption();
      table.add(*motion, naming([&] { return motion->at(times_s[k]); }, [&] { return placeOf(k, shape); }));
    }
  }
  return table.take(note);
}

std::string eventsJson(const LoadedScene& loaded, const std::optional<std::pair<double, double>>& span_s) {
  const scene::Scene& scene = loaded.scene();
  const scene::FilmClock clock = loaded.clock();
  const std::pair<double, double> film_s{scene.time.start_s, clock.motionTime_s(scene.time.duration_s)};
  const auto [from_s, to_s] = span_s.value_or(film_s);
  const auto motion = loaded.motionOver(from_s, to_s);
  const auto events = scene::sceneEvents(scene, *motion, clock, physics::TimeSpan{from_s, to_s});
  return reference::eventsText(events, reference::TrajectoryFormat::kJson, scene.name);
}

}  // namespace poinsot::python
