// SPDX-License-Identifier: Apache-2.0
#include "answers.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <span>

#include "checkup.h"
#include "compare/flip.h"
#include "diff.h"
#include "golden_report.h"
#include "grade.h"
#include "image/png_file.h"
#include "reference/scene_grade.h"
#include "reference/trajectory.h"
#include "scene/keys/explanation.h"
#include "signals.h"
#include "stability.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
using Words = LoadedScene::Words;

std::string diffOf(const PictureSource& reference, const PictureSource& test, RuleWords rule,
                   std::vector<std::vector<double>> ignore, const PictureSource& mask, double pixelsPerDegree,
                   int jobs, std::vector<std::string> limits) {
  return diffJson(reference, test,
                  {std::move(rule), std::move(ignore), mask, pixelsPerDegree, jobs, std::move(limits)});
}

py::bytes pngBytes(const py::array& pixels) {
  const compare::DiffPicture picture = pictureOf(pixels);
  std::vector<std::uint8_t> png;
  {
    const WithoutGil others;
    png = std::visit([](const auto& it) { return image::encodePng(it); }, picture.pixels);
  }
  return {reinterpret_cast<const char*>(png.data()), png.size()};
}

/// Row of write_golden_report(), which returns JSON and Markdown. Parts: name, status, message, place, baseline,
/// new picture, rule, ignored boxes, mask.
using RowParts = std::tuple<std::string, std::string, std::string, py::bytes, py::bytes, py::bytes, RuleWords,
                            std::vector<std::vector<double>>, py::bytes>;

std::pair<std::string, std::string> writeReport(const std::string& page, const std::string& title,
                                                const std::string& tree, const std::vector<RowParts>& parts,
                                                int jobs) {
  std::vector<GoldenRow> rows;
  for (const auto& [name, status, message, place, baseline, actual, rule, ignore, mask] : parts)
    rows.push_back({name, status, message, std::string(place), std::string(baseline), std::string(actual), rule,
                    ignore, std::string(mask)});
  const WithoutGil others;
  GoldenTexts texts = writeGoldenReport(page, title, tree, rows, jobs);
  return {std::move(texts.json), std::move(texts.markdown)};
}

/// Title and help of an explanation, and its rows of name and text.
using Explained = std::tuple<std::string, std::string, std::vector<std::pair<std::string, std::string>>>;

std::vector<Explained> explanationsOf(const std::string& word) {
  std::vector<Explained> all;
  for (const scene::Explanation& one : scene::explain(word)) {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const auto& row : one.rows) rows.emplace_back(row.name, row.text);
    all.emplace_back(one.title, one.help, std::move(rows));
  }
  return all;
}

Words namesOf(std::span<const reference::TrajectoryColumn> columns) {
  Words names;
  for (const reference::TrajectoryColumn& column : columns) names.emplace_back(column.name);
  return names;
}

Words trajectoryColumns(const LoadedScene& scene) {
  return namesOf(reference::trajectoryColumns(scene.scene().motion.forcing.dissipation));
}

void declareClasses(const py::module_& module) {
  py::class_<Remark>(module, "Remark")
      .def_readonly("file", &Remark::file)
      .def_readonly("line", &Remark::line)
      .def_readonly("column", &Remark::column)
      .def_readonly("message", &Remark::message);
  py::class_<Checkup>(module, "Checkup")
      .def_readonly("problems", &Checkup::problems)
      .def_readonly("notes", &Checkup::notes)
      .def_readonly("film_memory", &Checkup::filmMemory_bytes)
      .def_readonly("picture_memory", &Checkup::pictureMemory_bytes);
  py::class_<StabilityNumbers>(module, "StabilityNumbers")
      .def_readonly("flip_interval", &StabilityNumbers::flipInterval)
      .def_readonly("moments", &StabilityNumbers::moments)
      .def_readonly("R_BP", &StabilityNumbers::R_BP)
      .def_readonly("L_P", &StabilityNumbers::L_P)
      .def_readonly("separatrix_P", &StabilityNumbers::separatrix)
      .def_readonly("scene_interval", &StabilityNumbers::sceneInterval_s)
      .def_readonly("least", &StabilityNumbers::least_s)
      .def_readonly("most", &StabilityNumbers::most_s)
      .def_readonly("logarithmic", &StabilityNumbers::logarithmic);
}

}  // namespace

void declareAnswers(py::module_& module) {
  declareClasses(module);
  module.attr("all_trajectory_columns") = namesOf(reference::kTrajectoryColumns);
  module.attr("flip_pixels_per_degree") = compare::kFlipPixelsPerDegree;
  module.def("attitude_limit", &reference::attitudeLimit_rad);
  module.def("check_rule",
             [](const RuleWords& rule, const std::vector<std::vector<double>>& ignore) { ruleOf(rule, ignore); });
  module.def("checkup", &checkupOf, py::call_guard<WithoutGil>());
  module.def("diff", &diffOf);
  module.def("explain", &explanationsOf);
  module.def("grade_file", py::overload_cast<const LoadedScene&, const std::string&>(&gradeJson));
  module.def("grade_columns",
             py::overload_cast<const LoadedScene&, const Words&, const std::vector<Column>&>(&gradeJson));
  module.def("png_of", &pngBytes);
  module.def("stability", &stabilityOf);
  module.def("trajectory_columns", &trajectoryColumns);
  module.def("write_golden_report", &writeReport);
}

}  // namespace poinsot::python
