// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/golden_manifest.h"
#include "app/golden_reference.h"
#include "app/picture_diff.h"
#include "gl/offscreen_context.h"

namespace poinsot::app {

/// One picture to compare.
struct GoldenCase {
  std::string name;  ///< of the test, with the time where there are several: "racket_t1.5"
  GoldenTest test;
  std::optional<double> time_s;
  std::filesystem::path actual;  ///< where the new picture is

  GoldenName reference() const { return {name, actual.extension()}; }
  /// What made the picture of an image, as the user says; empty if nothing is said, and of a scene.
  std::string variant() const { return test.image.empty() ? "" : test.variant; }
};

enum class GoldenStatus {
  kIdentical,
  kNear,
  kDifferent,
  kNew,     ///< nothing was approved
  kUnused,  ///< approved, and no test makes it
  kError    ///< no picture, or one that cannot be read
};

/// "identical", "near", "different", "new", "unused", "error".
std::string_view toString(GoldenStatus status);

/// What came of a case.
struct GoldenOutcome {
  std::string name;
  GoldenStatus status = GoldenStatus::kError;
  std::string message;                    ///< why it is no pass; the reason of its rule where it is near by one
  PictureDiff diff;                       ///< against `reference`; figures where both could be compared
  std::filesystem::path reference;        ///< the nearest of those approved; empty if none
  std::filesystem::path actual;           ///< the new picture; empty if there is none
  std::filesystem::path map, difference;  ///< where the pictures are not identical
  GoldenOrigin origin;                    ///< of the new picture
  double seconds = 0;                     ///< of comparing

  bool passes(bool exact) const {
    return status == GoldenStatus::kIdentical || (status == GoldenStatus::kNear && !exact);
  }
};

struct GoldenRequest {
  std::vector<std::string> only;  ///< names of tests or of cases, * for any characters; empty: all
  std::filesystem::path output;   ///< folder of new pictures and maps; exists
  int jobs = 1;
  gl::Backend backend = gl::Backend::kAuto;
  bool reproducible = true;
  scene::Allowance allowance = {};
  std::string variant = {};  ///< of all images, in place of what their tests say
};

/// The cases of a manifest that are asked for. @throws core::Error(kUsage) for a name that is none.
std::vector<GoldenCase> casesOf(const GoldenManifest& manifest, const GoldenRequest& request);

/// @throws core::Error(kUsage) if a case has a variant for which no reference of any case was approved, although
/// some were: probably a slip.
void expectKnownVariants(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases);

/// Makes the pictures of all cases and compares them with what was approved; `jobs` at a time. Where all cases are
/// run, references that belong to none are told as well. In order of the cases, whatever the jobs.
/// @throws Interrupted; core::Error(kIo) if pictures of the comparison cannot be written.
std::vector<GoldenOutcome> runGoldens(const GoldenManifest& manifest, const GoldenRequest& request);

}  // namespace poinsot::app
