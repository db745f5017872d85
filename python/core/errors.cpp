// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include <pybind11/pybind11.h>

#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file_error.h"
#include "scene/document/problem.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
using core::ErrorKind;

const char* nameOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return "usage";
    case ErrorKind::kScene:
      return "scene";
    case ErrorKind::kLimit:
      return "limit";
    case ErrorKind::kPhysics:
      return "physics";
    case ErrorKind::kGraphics:
    case ErrorKind::kEncode:
      return "render";
    case ErrorKind::kIo:
      return "file";
  }
  return "";
}

py::object inErrors(const char* name) { return py::module_::import("poinsot._errors").attr(name); }

std::string inPython(const std::string& message) { return py::cast<std::string>(inErrors("in_python")(message)); }

template <class... Facts>
void raise(ErrorKind kind, const std::string& text, const Facts&... facts) {
  const py::object error = inErrors("made")(nameOf(kind), text, facts...);
  PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
}

void raise(const core::FileError& error) {
  const std::string text = inPython(error.what());
  if (error.kind() == ErrorKind::kLimit) return raise(error.kind(), text);
  const py::object name = py::module_::import("os").attr("fsdecode")(py::bytes(error.file().native()));
  raise(ErrorKind::kIo, text, py::tuple(), error.code(), name);
}

/// Removes the option from the place of an override. @returns the key; empty for a problem of a file.
std::string takeOverride(scene::Problem& problem) {
  constexpr std::string_view kOption = "-D ";  // begins the file name of an override's place
  std::string& place = problem.where.file;
  if (problem.where.line != 0 || !place.starts_with(kOption)) return "";
  place.erase(0, kOption.size());
  return place.substr(0, place.find('='));
}

void raise(const scene::SceneErrors& errors) {
  const py::object makeProblem = inErrors("Problem");
  std::vector<scene::Problem> problems = errors.problems();
  py::list listed;
  for (scene::Problem& problem : problems) {
    const std::string key = takeOverride(problem);
    problem.message = inPython(problem.message);
    listed.append(makeProblem(key.empty() ? problem.where.file : "", problem.where.line, problem.where.column,
                              problem.message, key));
  }
  raise(errors.kind(), scene::SceneErrors(std::move(problems), errors.omitted()).what(), listed);
}

}  // namespace

void translateErrors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const scene::SceneErrors& errors) {
      raise(errors);
    } catch (const core::FileError& error) {
      raise(error);
    } catch (const core::Error& error) {
      raise(error.kind(), inPython(error.what()));
    }
  });
}

}  // namespace poinsot::python
