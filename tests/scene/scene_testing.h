// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/scene_file.h"

/// Shared by the tests of the scene layer.
namespace poinsot::scene {

inline std::string dataPath(const std::string& name) {
  return std::string(POINSOT_SOURCE_DIR) + "/tests/scene/data/" + name;
}

constexpr const char* kMinimal =
    "[body]\n"
    "principal_moments = [1.0, 2.0, 2.5]\n"
    "[motion]\n"
    "omega_body = [0.01, 3.0, 0.0]\n";

/// What is wrong with a text; none when nothing is.
inline std::vector<Problem> problemsOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parseScene(text, "test.toml", overrides);
  } catch (const SceneErrors& errors) {
    return errors.problems();
  }
  return {};
}

inline std::string messagesOf(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::string messages;
  for (const Problem& problem : problemsOf(text, overrides)) messages += problem.message + "\n";
  return messages;
}

}  // namespace poinsot::scene
