// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "scene/scene_file.h"

/// Shared by the tests of the scene layer.
namespace poinsot::scene {

inline std::string dataPath(const std::string& name) { return POINSOT_SOURCE_DIR "/tests/scene/data/" + name; }

constexpr const char* kMinimal =
    "[body]\n"
    "principal_moments = [1.0, 2.0, 2.5]\n"
    "[motion]\n"
    "omega_body = [0.01, 3.0, 0.0]\n";

/// Returns the problems of a scene text. Files that the text names are searched beside `fileName`.
inline std::vector<Problem> problemsOf(const std::string& text, const std::vector<std::string>& overrides = {},
                                       const std::string& fileName = "test.toml") {
  try {
    parseScene(text, fileName, overrides);
  } catch (const SceneErrors& errors) {
    return errors.problems();
  }
  return {};
}

inline std::string messagesOf(const std::string& text, const std::vector<std::string>& overrides = {},
                              const std::string& fileName = "test.toml") {
  std::string messages;
  for (const Problem& problem : problemsOf(text, overrides, fileName)) messages += problem.message + "\n";
  return messages;
}

/// Returns a part's solid. @throws std::bad_variant_access if the part is of another type.
template <class Solid>
const Solid& solidOf(const Part& part) {
  return std::get<Solid>(std::get<physics::Solid>(part.figure));
}

}  // namespace poinsot::scene
