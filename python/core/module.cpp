// SPDX-License-Identifier: Apache-2.0
// What poinsot/*.py is made of: the layers as Python sees them. Docstrings, defaults and rich display are there;
// types are in poinsot/_core.pyi.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers.h"
#include "app/alt_text.h"
#include "app/report_scene.h"
#include "core/version.h"
#include "errors.h"
#include "loaded_scene.h"
#include "pictures.h"
#include "trajectory.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
using ReleaseGil = py::call_guard<py::gil_scoped_release>;
using Size = std::optional<std::pair<int, int>>;

PictureAsk askOf(std::optional<double> time_s, const Size& size, bool transparent, int bits) {
  PictureAsk ask{time_s, std::nullopt, transparent, bits};
  if (size) ask.size = image::PixelSize{size->first, size->second};
  return ask;
}

/// Rows, columns, channels. The array owns the pixels.
template <class Sample>
py::array arrayOf(image::BasicImage<Sample> picture) {
  auto* owned = new image::BasicImage<Sample>(std::move(picture));
  const py::capsule owner(owned, [](void* it) { delete static_cast<image::BasicImage<Sample>*>(it); });
  return py::array_t<Sample>({owned->size.height, owned->size.width, owned->channels}, owned->pixels.data(),
                             owner);
}

py::array picture(const LoadedScene& scene, std::optional<double> time_s, const Size& size, bool transparent,
                  int bits) {
  image::AnyImage drawn;
  {
    const py::gil_scoped_release others;
    drawn = pictureOf(scene, askOf(time_s, size, transparent, bits));
  }
  return std::visit([](auto& image) { return arrayOf(std::move(image)); }, drawn);
}

py::bytes png(const LoadedScene& scene, std::optional<double> time_s, const Size& size) {
  std::vector<std::uint8_t> file;
  {
    const py::gil_scoped_release others;
    file = pngOf(scene, askOf(time_s, size, false, 8));
  }
  return {reinterpret_cast<const char*>(file.data()), file.size()};
}

void declareScene(const py::module_& module) {
  py::class_<LoadedScene>(module, "Scene")
      .def_static("of_file", &LoadedScene::ofFile, ReleaseGil())
      .def_static("of_text", &LoadedScene::ofText, ReleaseGil())
      .def_property_readonly("name", [](const LoadedScene& it) { return it.scene().name; })
      .def_property_readonly("file_name", [](const LoadedScene& it) { return it.request().fileName; })
      .def_property_readonly("text", [](const LoadedScene& it) { return it.request().text; })
      .def_property_readonly("overrides", [](const LoadedScene& it) { return it.request().overrides; })
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
      .def("motion_times", &LoadedScene::motionTimes_s, ReleaseGil())
      .def("trajectory", &trajectoryOf)
      .def("picture", &picture)
      .def("png", &png)
      .def(
          "info_json", [](const LoadedScene& it) { return app::reportJson(app::sceneReport(it.scene())); },
          ReleaseGil())
      .def(
          "alt_text", [](const LoadedScene& it) { return app::altText(it.scene()); }, ReleaseGil());
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
      .def_readonly("note", &TrajectoryArrays::note);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  translateErrors();
  declareScene(module);
  declareTrajectory(module);
  declareAnswers(module);
  module.attr("version") = core::version();
}

}  // namespace poinsot::python
