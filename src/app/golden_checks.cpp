// SPDX-License-Identifier: Apache-2.0
#include "app/golden_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>
#include <system_error>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

/// Returns the renderers for which references of images with a variant were approved; "" where none is known.
std::set<std::string> approvedRenderers(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases) {
  std::set<std::string> renderers;
  for (const GoldenCase& one : cases) {
    if (one.variant().empty()) continue;
    try {
      for (const GoldenReference& reference : referencesOf(manifest.references, one.reference()))
        renderers.insert(reference.origin.renderer);
    } catch (const core::Error&) {  // is reported when the case is compared
    }
  }
  return renderers;
}

}  // namespace

void expectKnownVariants(const GoldenManifest& manifest, const GoldenRequest& request,
                         const std::string& approveBy) {
  GoldenRequest all = request;
  all.only.clear();
  const std::set<std::string> renderers = approvedRenderers(manifest, casesOf(manifest, all));
  if (renderers.empty()) return;
  for (const GoldenCase& one : casesOf(manifest, request)) {
    if (one.variant().empty() || renderers.contains(one.variant())) continue;
    std::vector<std::string> known;
    for (const std::string& renderer : renderers)
      if (!renderer.empty()) known.push_back(renderer);
    throw core::Error(core::ErrorKind::kUsage,
                      fmt::format("variant '{}': no reference was approved for it; {}; approve the first by {}",
                                  core::printable(one.variant()),
                                  known.empty() ? "there are none with a variant"
                                                : fmt::format("there are {}", fmt::join(known, ", ")),
                                  approveBy));
  }
}

void expectReferencesKept(const std::vector<GoldenCase>& cases, const fs::path& references,
                          const fs::path& output) {
  std::error_code ignored;
  std::set<fs::path> approved;
  for (const GoldenCase& one : cases)
    approved.insert(fs::weakly_canonical(references / (one.name + one.actual.extension().native()), ignored));
  bool replaces = fs::equivalent(output, references, ignored);
  for (const GoldenCase& one : cases) {
    for (const std::string_view ending : {kMapEnding, kDifferenceEnding})
      replaces = replaces || approved.contains(fs::weakly_canonical(one.fileIn(output, ending), ignored));
    replaces =
        replaces || (!one.test.scene.empty() && approved.contains(fs::weakly_canonical(one.actual, ignored)));
  }
  if (replaces)
    throw core::Error(core::ErrorKind::kUsage,
                      fmt::format("-o {}: contains the approved references; choose another folder",
                                  core::printable(output.native())));
}

void expectImagesKept(const std::vector<GoldenCase>& cases, const fs::path& output) {
  std::error_code ignored;
  std::map<fs::path, const GoldenCase*> images;
  for (const GoldenCase& one : cases)
    if (one.test.scene.empty() && !one.test.isUnmatched) images[fs::weakly_canonical(one.actual, ignored)] = &one;
  for (const GoldenCase& one : cases)
    for (const std::string_view ending : {kMapEnding, kDifferenceEnding})
      if (const auto image = images.find(fs::weakly_canonical(one.fileIn(output, ending), ignored));
          image != images.end())
        throw core::Error(core::ErrorKind::kUsage,
                          fmt::format("-o {}: a map of '{}' would replace the image {}; choose another folder",
                                      core::printable(output.native()), one.name,
                                      core::printable(image->second->actual.native())));
}

}  // namespace poinsot::app
