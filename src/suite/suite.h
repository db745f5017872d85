// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compare/outcome.h"
#include "gl/offscreen_context.h"
#include "output/run_files.h"
#include "suite/manifest.h"
#include "suite/reference.h"

namespace poinsot::suite {

/// Endings of the files that a run writes beside a case's picture: the FLIP map and the difference.
inline constexpr std::string_view kMapEnding = ".flip.png", kDifferenceEnding = ".difference.png";

/// Picture to compare: a test at one of its times.
struct GoldenCase {
  std::string name;  ///< the test's name, with the time if there are several: "racket_t1.5"
  GoldenTest test;
  std::optional<double> time_s;
  std::filesystem::path actual;  ///< file of the new picture
  std::set<std::string> taken;   ///< stems NAME@X that are names of other tests

  /// Returns a file that the run writes to its output folder. @param ending  kMapEnding or kDifferenceEnding
  std::filesystem::path fileIn(const std::filesystem::path& output, std::string_view ending) const {
    return output / (name + std::string(ending));
  }
  GoldenName reference() const { return {name, actual.extension(), taken}; }
  /// Returns the variant that the user chose for an image; empty without a variant, and for a scene.
  std::string variant() const { return test.image.empty() ? "" : test.variant; }
};

/// Enters the files that a run may write for a case: two maps and, if the case has a scene, its picture.
/// @throws core::Error as RunFiles::writesInNewFolder()
void enterFilesMade(output::RunFiles& files, const GoldenCase& one, const std::filesystem::path& output);

struct GoldenRequest {
  /// Names of tests or cases, in which * matches any characters, or files as written in the manifest; empty for
  /// all.
  std::vector<std::string> only;
  std::filesystem::path output;  ///< existing folder of new pictures and maps
  int jobs = 1;
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = true;
  scene::Allowance allowance = {};
  std::string variant = {};           ///< variant of all images, overrides the manifest
  output::RunFiles* files = nullptr;  ///< files of the run; receives the inputs of the scenes
};

/// Returns the requested cases of a manifest. @throws core::Error(kUsage) if a requested name matches no case
std::vector<GoldenCase> casesOf(const GoldenManifest& manifest, const GoldenRequest& request);

/// Draws the pictures of all requested cases and compares them with their references, `jobs` at a time. Outcomes
/// are in the order of the cases and do not depend on `jobs`. Stray references follow.
/// @throws Interrupted; core::Error(kIo) if the maps cannot be written
std::vector<compare::Outcome> runGoldens(const GoldenManifest& manifest, const GoldenRequest& request);

/// Returns the cases of a suite as JSON, each with its scene or image as written in the manifest.
std::string casesJson(const std::vector<GoldenCase>& cases);

}  // namespace poinsot::suite
