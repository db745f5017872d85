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

/// Endings of the two files that a run writes for each case: the FLIP map and the amplified difference.
inline constexpr std::string_view kMapEnding = ".flip.png", kDifferenceEnding = ".difference.png";

/// Picture to compare: a test has one picture for each of its film times.
struct GoldenCase {
  std::string name;  ///< test's name, with the time if there are several ("racket_t1.5")
  GoldenTest test;
  std::optional<double> time_s;
  std::filesystem::path actual;  ///< file of the new picture
  std::set<std::string> taken;   ///< names NAME@X of other tests, which are not references of NAME

  /// Returns the path of the case's map or difference in the output folder. @param ending kMapEnding or
  /// kDifferenceEnding
  std::filesystem::path fileIn(const std::filesystem::path& output, std::string_view ending) const {
    return output / (name + std::string(ending));
  }
  GoldenName reference() const { return {name, actual.extension(), taken}; }
  /// Returns the variant that the user chose for an image. Empty if no variant was chosen, and for scenes.
  std::string variant() const { return test.image.empty() ? "" : test.variant; }
};

/// Registers the files that a run may write for a case: two maps and, if the case has a scene, its picture.
/// @throws core::Error as RunFiles::writesInNewFolder()
void enterFilesMade(output::RunFiles& files, const GoldenCase& one, const std::filesystem::path& output);

struct GoldenRequest {
  /// Requested tests; empty for all. An entry is the name of a test or case, in which * matches any characters, or
  /// a file as written in the manifest.
  std::vector<std::string> only;
  std::filesystem::path output;  ///< existing folder for new pictures and maps
  int jobs = 1;
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = true;
  scene::Allowance allowance = {};
  std::string variant = {};           ///< variant of all images; overrides the manifest
  output::RunFiles* files = nullptr;  ///< files of the run, to which the scenes' inputs are added
};

/// Returns the requested cases of a manifest. @throws core::Error(kUsage) if a requested name matches no case
std::vector<GoldenCase> casesOf(const GoldenManifest& manifest, const GoldenRequest& request);

/// Draws the pictures of all requested cases, `jobs` at a time, and compares them with their references. Returns
/// an outcome for each case, in the order of the cases, then outcomes for stray references. The result does not
/// depend on `jobs`.
/// @throws Interrupted; core::Error(kIo) if the maps cannot be written
std::vector<compare::Outcome> runGoldens(const GoldenManifest& manifest, const GoldenRequest& request);

/// Returns the cases of a suite as JSON. Each case has its scene or image as written in the manifest.
std::string casesJson(const std::vector<GoldenCase>& cases);

}  // namespace poinsot::suite
