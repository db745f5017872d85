// SPDX-License-Identifier: Apache-2.0
#include "grade.h"

#include "reference/grade_text.h"
#include "reference/scene_grade.h"
#include "signals.h"

namespace poinsot::python {
namespace {

std::string json(const LoadedScene& loaded, const reference::TrajectoryTable& theirs,
                 const std::string& fileName) {
  const scene::Scene& scene = loaded.scene();
  return reference::gradeJson(reference::gradeAgainst(scene, theirs), fileName, scene.name);
}

}  // namespace

std::string gradeJson(const LoadedScene& scene, const std::string& fileName) {
  const WithoutGil others;
  return json(scene, reference::readTrajectoryTable(fileName), fileName);
}

std::string gradeJson(const LoadedScene& scene, const std::vector<std::string>& names,
                      const std::vector<Column>& columns) {
  std::vector<reference::NamedColumn> named;
  for (std::size_t i = 0; i < columns.size(); ++i)
    named.push_back({names.at(i), {columns[i].data(), static_cast<std::size_t>(columns[i].size())}});
  const WithoutGil others;
  return json(scene, reference::trajectoryTableOf(named), "");
}

}  // namespace poinsot::python
