// SPDX-License-Identifier: Apache-2.0
// Binding of the libraries for poinsot/*.py, which adds docstrings, defaults, checks of arguments and rich
// display. The types are in poinsot/_core.pyi.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers.h"
#include "core/version.h"
#include "describe/alt_text.h"
#include "describe/report.h"
#include "errors.h"
#include "loaded_scene.h"
#include "pictures.h"
#include "signals.h"
#include "trajectory.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
using Interruptible = py::call_guard<WithoutGil>;
using SharedScene = std::shared_ptr<LoadedScene>;
using Size = std::optional<std::pair<std::int64_t, std::int64_t>>;

/// Converts a file name, or a part of one, which need not be UTF-8.
py::str fileText(const std::string& name) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeFSDefaultAndSize(name.data(), static_cast<Py_ssize_t>(name.size())));
}

Doubles motionTimes(const LoadedScene& scene, const Doubles& filmTimes_s) {
  Doubles times_s(std::vector<py::ssize_t>(filmTimes_s.shape(), filmTimes_s.shape() + filmTimes_s.ndim()));
  const scene::FilmClock clock = scene.clock();
  std::transform(filmTimes_s.data(), filmTimes_s.data() + filmTimes_s.size(), times_s.mutable_data(),
                 [&](double t_s) { return clock.motionTime_s(t_s); });
  return times_s;
}

PictureAsk askOf(const LoadedScene& scene, std::optional<double> time_s, const Size& size, bool transparent,
                 int bits) {
  const scene::Output& own = scene.scene().output;
  PictureAsk ask{time_s.value_or(scene.scene().time.stillTime_s()), {own.width, own.height}, transparent, bits};
  if (!size) return ask;
  requireSides(size->first, size->second, scene.limits());
  ask.size = {static_cast<int>(size->first), static_cast<int>(size->second)};
  return ask;
}

/// Returns an array of rows, columns and channels, which owns the pixels.
template <class Sample>
py::array arrayOf(image::BasicImage<Sample> picture) {
  auto* owned = new image::BasicImage<Sample>(std::move(picture));
  const py::capsule owner(owned, [](void* it) { delete static_cast<image::BasicImage<Sample>*>(it); });
  return py::array_t<Sample>({owned->size.height, owned->size.width, owned->channels}, owned->pixels.data(),
                             owner);
}

py::array picture(const SharedScene& scene, std::optional<double> time_s, const Size& size, bool transparent,
                  int bits) {
  image::AnyImage drawn;
  {
    const WithoutGil others;
    drawn = pictureOf(scene, askOf(*scene, time_s, size, transparent, bits));
  }
  return std::visit([](auto& image) { return arrayOf(std::move(image)); }, drawn);
}

py::bytes png(const SharedScene& scene, std::optional<double> time_s, const Size& size) {
  std::vector<std::uint8_t> file;
  {
    const WithoutGil others;
    file = pngOf(scene, askOf(*scene, time_s, size, false, 8));
  }
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

void declareScene(const py::module_& module) {
  py::class_<LoadedScene, SharedScene>(module, "Scene")
      .def_static("of_file", &LoadedScene::ofFile, Interruptible())
      .def_static("of_text", &LoadedScene::ofText, Interruptible())
      .def_property_readonly("name", [](const LoadedScene& it) { return fileText(it.scene().name); })
      .def_property_readonly("text", [](const LoadedScene& it) { return it.request().text; })
      .def_property_readonly(
          "size",
          [](const LoadedScene& it) { return std::pair(it.scene().output.width, it.scene().output.height); })
      .def_property_readonly("fps",
                             [](const LoadedScene& it) {
                               const core::Rational& fps = it.scene().time.fps;
                               return std::pair(fps.num, fps.den);
                             })
      .def_property_readonly("duration", [](const LoadedScene& it) { return it.scene().time.duration_s; })
      .def_property_readonly("frame_count", &LoadedScene::frameCount)
      .def("require_sides", [](const LoadedScene& it, std::int64_t width,
                               std::int64_t height) { requireSides(width, height, it.limits()); })
      .def("motion_times", &motionTimes)
      .def("trajectory", &trajectoryOf)
      .def("events_json", &eventsJson, Interruptible())
      .def("picture", &picture)
      .def("png", &png)
      .def(
          "info_json",
          [](const LoadedScene& it) { return describe::reportJson(describe::sceneReport(it.scene())); },
          Interruptible())
      .def(
          "alt_text", [](const LoadedScene& it) { return describe::altText(it.scene()); }, Interruptible());
}

void declareTrajectory(const py::module_& module) {
  py::class_<TrajectoryArrays>(module, "TrajectoryArrays")
      .def_readonly("q_WB", &TrajectoryArrays::q_WB)
      .def_readonly("R_WB", &TrajectoryArrays::R_WB)
      .def_readonly("omega_B", &TrajectoryArrays::omega_B)
      .def_readonly("omega_W", &TrajectoryArrays::omega_W)
      .def_readonly("L_W", &TrajectoryArrays::L_W)
      .def_readonly("T", &TrajectoryArrays::T)
      .def_readonly("rate_B", &TrajectoryArrays::rate_B)
      .def_readonly("rate_W", &TrajectoryArrays::rate_W)
      .def_readonly("quantities", &TrajectoryArrays::quantities)
      .def_readonly("note", &TrajectoryArrays::note);
}

void declare(py::module_ module) {
  rememberMainThread();
  translateErrors();
  declareScene(module);
  declareTrajectory(module);
  declareAnswers(module);
  module.attr("version") = core::version();
  const auto finish = [] {
    const py::gil_scoped_release others;
    leaveThreadsAlone();
    finishPictures();
  };
  py::module_::import("atexit").attr("register")(py::cpp_function(finish));
}

/// Fills the module on each import. Later imports copy the contents of the first, because pybind11 registers a
/// class only once per process. Fails in a subinterpreter, whose GIL pybind11 would await forever.
int fill(PyObject* object) {
  if (PyInterpreterState_Get() != PyInterpreterState_Main()) {
    PyErr_SetString(PyExc_ImportError,
                    "poinsot works only in the main interpreter, not in a subinterpreter; with mod_wsgi, set "
                    "WSGIApplicationGroup %{GLOBAL}; otherwise, start another process");
    return -1;
  }
  static PyObject* first = nullptr;
  if (first != nullptr) return PyDict_Merge(PyModule_GetDict(object), PyModule_GetDict(first), 0);
  try {
    declare(py::reinterpret_borrow<py::module_>(object));
  } catch (py::error_already_set& error) {
    error.restore();
    return -1;
  }
  first = Py_NewRef(object);
  return 0;
}

PyModuleDef_Slot slots[] = {{Py_mod_exec, reinterpret_cast<void*>(fill)},
#ifdef Py_mod_multiple_interpreters
                            {Py_mod_multiple_interpreters, Py_MOD_MULTIPLE_INTERPRETERS_NOT_SUPPORTED},
#endif
                            {0, nullptr}};
PyModuleDef definition{PyModuleDef_HEAD_INIT, "_core", nullptr, 0, nullptr, slots, nullptr, nullptr, nullptr};

}  // namespace
}  // namespace poinsot::python

// PYBIND11_MODULE is not used, because its own first step hangs in a subinterpreter.
extern "C" PYBIND11_EXPORT PyObject* PyInit__core() { return PyModuleDef_Init(&poinsot::python::definition); }
