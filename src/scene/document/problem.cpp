// SPDX-License-Identifier: Apache-2.0
#include "scene/document/problem.h"

#include <fmt/format.h>

#include "core/expect.h"

namespace poinsot::scene {
namespace {

std::string underlined(const Problem& problem) {
  const std::string number = fmt::format("{:>4}", problem.where.line);
  return fmt::format("\n{} | {}\n{:{}} | {:{}}{:^<{}}", number, problem.sourceLine, "", number.size(), "",
                     problem.caret, "", problem.caretLength);
}

std::string report(const std::vector<Problem>& problems, int omitted) {
  std::string text;
  for (const Problem& problem : problems) text += (text.empty() ? "" : "\n") + toString(problem);
  if (omitted > 0) text += fmt::format("\nand {} more", omitted);
  return text;
}

}  // namespace

std::string toString(const Problem& problem) {
  std::string text = fmt::format("{}: error: {}", core::toString(problem.where), problem.message);
  if (!problem.sourceLine.empty()) text += underlined(problem);
  return text;
}

std::string toString(const Doubt& doubt) {
  return fmt::format("{}: note: {}", core::toString(doubt.where), doubt.message);
}

SceneErrors::SceneErrors(std::vector<Problem> problems, int omitted)
    : core::Error(core::ErrorKind::kScene, report(problems, omitted)),
      problems_(std::move(problems)),
      omitted_(omitted) {
  POINSOT_EXPECT(!problems_.empty());
}

}  // namespace poinsot::scene
