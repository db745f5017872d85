// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include <pybind11/pybind11.h>

#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "scene/problem.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
using core::ErrorKind;

const char* className(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return "UsageError";
    case ErrorKind::kScene:
      return "SceneError";
    case ErrorKind::kLimit:
      return "LimitError";
    case ErrorKind::kPhysics:
      return "PhysicsError";
    case ErrorKind::kGraphics:
    case ErrorKind::kEncode:
      return "RenderError";
    case ErrorKind::kIo:
      return "FileError";
  }
  return "Error";
}

py::object errorClass(const char* name) { return py::module_::import("poinsot._errors").attr(name); }

void raise(const py::object& error) { PyErr_SetObject(py::type::of(error).ptr(), error.ptr()); }

py::list problemsOf(const scene::SceneErrors& errors) {
  const py::object problem = errorClass("Problem");
  py::list all;
  for (const scene::Problem& one : errors.problems())
    all.append(problem(one.where.file, one.where.line, one.where.column, one.message));
  return all;
}

/// Of overrides without the command line's -D.
scene::SceneErrors inPython(const scene::SceneErrors& errors) {
  constexpr std::string_view kOption = "-D ";
  std::vector<scene::Problem> problems = errors.problems();
  for (scene::Problem& problem : problems)
    if (problem.where.line == 0 && problem.where.file.starts_with(kOption))
      problem.where.file.erase(0, kOption.size());
  return scene::SceneErrors(std::move(problems), errors.omitted());
}

}  // namespace

void translateErrors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const scene::SceneErrors& thrownErrors) {
      const scene::SceneErrors errors = inPython(thrownErrors);
      raise(errorClass("SceneError")(errors.what(), problemsOf(errors)));
    } catch (const core::Error& error) {
      raise(errorClass(className(error.kind()))(error.what()));
    }
  });
}

}  // namespace poinsot::python
