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

/// Endings of the files that a run writes beside the picture of a case: FLIP's map and the difference.
inline constexpr std::string_view kMapEnding = ".flip.png", kDifferenceEnding = ".difference.png";

/// One picture to compare.
struct GoldenCase {
  std::string name;  ///< of the test, with the time where there are several: "racket_t1.5"
  GoldenTest test;
  std::optional<double> time_s;
  std::filesystem::path actual;  ///< where the new picture is
  std::set<std::string> taken;   ///< stems NAME@X of other tests that begin with this name

  /// A file that a run writes into its output folder. @param ending  kMapEnding or kDifferenceEnding
  std::filesystem::path fileIn(const std::filesystem::path& output, std::string_view ending) const {
    return output / (name + std::string(ending));
  }
  GoldenName reference() const { return {name, actual.extension(), taken}; }
  /// Variant that the user names for an image; empty without one, and for a scene.
  std::string variant() const { return test.image.empty() ? "" : test.variant; }
};

/// Enters the files that a run may make for a case: its picture, unless another program makes that, and two maps.
/// @throws as RunFiles::writesInNewFolder()
void enterFilesMade(output::RunFiles& files, const GoldenCase& one, const std::filesystem::path& output);

struct GoldenRequest {
  /// Names of tests or of cases, * for any characters, or files as the manifest has them; empty: all.
  std::vector<std::string> only;
  std::filesystem::path output;  ///< folder of new pictures and maps; exists
  int jobs = 1;
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = true;
  scene::Allowance allowance = {};
  std::string variant = {};           ///< of all images, in place of what their tests say
  output::RunFiles* files = nullptr;  ///< of the run, with all that it writes: gets what its scenes read
};

/// The cases of a manifest that are asked for. @throws core::Error(kUsage) for a name that is none.
std::vector<GoldenCase> casesOf(const GoldenManifest& manifest, const GoldenRequest& request);

/// Makes the pictures of all cases and compares them with what was approved; `jobs` at a time. Where all cases are
/// run, references that belong to none are told as well. In order of the cases, whatever the jobs.
/// @throws Interrupted; core::Error(kIo) if pictures of the comparison cannot be written.
std::vector<compare::Outcome> runGoldens(const GoldenManifest& manifest, const GoldenRequest& request);

/// Returns the cases of a suite as JSON, each with its scene or image as the manifest names it.
std::string casesJson(const std::vector<GoldenCase>& cases);

}  // namespace poinsot::suite
