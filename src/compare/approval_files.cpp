// SPDX-License-Identifier: Apache-2.0
#include "compare/approval_files.h"

#include <optional>
#include <system_error>

#include "compare/run_facts.h"
#include "core/error.h"
#include "core/regular_file.h"
#include "core/sha256.h"
#include "request/picture_options.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  return core::readRegularFile(file, request::kMostPicture, core::ErrorKind::kIo);
}

std::optional<FileState> stateOf(const std::optional<std::string>& content) {
  if (!content) return std::nullopt;
  return FileState{content->size(), core::toHex(core::sha256(*content)), core::toHex(core::gitBlob(*content))};
}

std::optional<std::string> presentContent(const fs::path& file) {
  std::error_code failure;
  return fs::exists(fs::symlink_status(file, failure)) ? std::optional(contentOf(file)) : std::nullopt;
}

ApprovalStep stepOf(const ApprovalFile& file, const fs::path& place, const fs::path& page,
                    const std::string& embedded) {
  std::optional<std::string> content;
  if (!file.source.empty()) content = contentOf(file.source);
  if (!file.text.empty()) content = file.text;
  ApprovalStep step{place, stateOf(presentContent(file.place)), stateOf(content), {}, file.text};
  if (file.source.empty()) return step;
  step.source = fs::proximate(fs::absolute(file.source), fs::absolute(page).parent_path());
  step.isEmbedded = !embedded.empty() && *content == embedded;
  return step;
}

}  // namespace

std::vector<ApprovalStep> approvalSteps(const std::vector<ApprovalFile>& files, const fs::path& root,
                                        const fs::path& page, const std::string& embedded) try {
  std::vector<ApprovalStep> steps;
  for (const ApprovalFile& file : files) {
    const fs::path place = fs::weakly_canonical(fs::absolute(file.place)).lexically_relative(root);
    if (place.empty() || *place.begin() == "..") return {};
    steps.push_back(stepOf(file, place, page, embedded));
  }
  return steps;
} catch (const core::Error&) {  // such as a picture that was removed after the comparison
  return {};
} catch (const fs::filesystem_error&) {
  return {};
}

fs::path approvalRoot(const fs::path& place) {
  const std::optional<fs::path> tree = workTreeAround(place);
  return fs::weakly_canonical(tree ? *tree : fs::current_path());
}

}  // namespace poinsot::compare
