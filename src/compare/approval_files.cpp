// SPDX-License-Identifier: Apache-2.0
#include "compare/approval_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
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
using nlohmann::ordered_json;

std::string contentOf(const fs::path& file) {
  return core::readRegularFile(file, request::kMostPicture, core::ErrorKind::kIo);
}

/// Returns the size and the identifiers of a content. Null stands for a file that does not exist.
ordered_json stateOf(const std::optional<std::string>& content) {
  if (!content) return nullptr;
  return {{"size", content->size()},
          {"sha256", core::toHex(core::sha256(*content))},
          {"git", core::toHex(core::gitBlob(*content))}};
}

std::optional<std::string> presentContent(const fs::path& file) {
  std::error_code failure;
  return fs::exists(fs::symlink_status(file, failure)) ? std::optional(contentOf(file)) : std::nullopt;
}

ordered_json fileJson(const ApprovalFile& file, const fs::path& place, const fs::path& page,
                      const std::string& embedded) {
  std::optional<std::string> content;
  if (!file.source.empty()) content = contentOf(file.source);
  if (!file.text.empty()) content = file.text;
  ordered_json json{
      {"place", place.generic_string()}, {"old", stateOf(presentContent(file.place))}, {"new", stateOf(content)}};
  if (!file.text.empty()) json["text"] = file.text;
  if (file.source.empty()) return json;
  json["source"] = fs::proximate(fs::absolute(file.source), fs::absolute(page).parent_path()).generic_string();
  json["embedded"] = !embedded.empty() && *content == embedded;
  return json;
}

}  // namespace

ordered_json approvalJson(const std::vector<ApprovalFile>& files, const fs::path& root, const fs::path& page,
                          const std::string& embedded) try {
  ordered_json all = ordered_json::array();
  for (const ApprovalFile& file : files) {
    const fs::path place = fs::weakly_canonical(fs::absolute(file.place)).lexically_relative(root);
    if (place.empty() || *place.begin() == "..") return nullptr;
    all.push_back(fileJson(file, place, page, embedded));
  }
  return all.empty() ? ordered_json() : all;
} catch (const core::Error&) {  // such as a picture that was removed after the comparison
  return nullptr;
} catch (const fs::filesystem_error&) {
  return nullptr;
}

fs::path approvalRoot(const fs::path& place) {
  const std::optional<fs::path> tree = workTreeAround(place);
  return fs::weakly_canonical(tree ? *tree : fs::current_path());
}

}  // namespace poinsot::compare
