// SPDX-License-Identifier: Apache-2.0
#include "compare/page_approval.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "compare/diff_page.h"
#include "core/atomic_file.h"
#include "core/base64.h"
#include "core/error.h"
#include "core/folder.h"
#include "core/regular_file.h"
#include "core/sha256.h"
#include "core/text.h"
#include "core/wildcard.h"
#include "request/picture_options.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostPage = std::size_t{512} << 20;

std::string shown(const fs::path& path) { return core::printable(path.native()); }

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw core::ioError(fmt::format("{}: {}; nothing was approved", shown(file), reason));
}

/// Returns the data of a page. See diff_page.html for its place.
json dataOf(const fs::path& page) {
  const std::string html = core::readRegularFile(page, kMostPage, core::ErrorKind::kIo);
  if (!reportKind().isOwn(page)) refuse(page, "is not a report of poinsot, or was edited");
  constexpr std::string_view kBegin = R"(<script id="data" type="application/json">)";
  const std::size_t begin = html.find(kBegin), end = html.find("</script>", begin);
  if (begin == std::string::npos || end == std::string::npos)
    refuse(page, "has no data; write it again with --report");
  json data = json::parse(html.substr(begin + kBegin.size(), end - begin - kBegin.size()), nullptr, false);
  if (!data.is_object() || !data["entries"].is_array())
    refuse(page, "has damaged data; write it again with --report");
  return data;
}

bool isMeant(const json& row, const std::string& pattern) {
  return core::matchesWildcard(pattern.starts_with("./-") ? pattern.substr(2) : pattern, row.value("name", ""));
}

bool canBeApproved(const json& row) { return row.contains("files") && row["files"].is_array(); }

/// Returns the rows to approve, in the order of the page.
std::vector<const json*> meantRows(const json& data, const std::vector<std::string>& names, const fs::path& page) {
  std::vector<std::string> known;
  for (const json& row : data["entries"])
    if (canBeApproved(row)) known.push_back(row.value("name", ""));
  for (const std::string& name : names) {
    const auto matches = [&](const json& row) { return canBeApproved(row) && isMeant(row, name); };
    if (std::ranges::any_of(data["entries"], matches)) continue;
    const auto near = core::closest(name, known);
    throw core::usageError(fmt::format("golden approve: {}: {} has no picture to approve with this name{}",
                                       core::printable(name), shown(page),
                                       near ? fmt::format("; did you mean '{}'?", core::printable(*near)) : ""));
  }
  std::vector<const json*> rows;
  for (const json& row : data["entries"])
    if (canBeApproved(row) &&
        std::ranges::any_of(names, [&](const std::string& name) { return isMeant(row, name); }))
      rows.push_back(&row);
  return rows;
}

/// Returns the path of a file below `root`. The page may be from elsewhere, so its paths are not trusted.
fs::path placeOf(const json& file, const fs::path& root) {
  const fs::path place = file.value("place", "");
  const auto isUp = [](const fs::path& part) { return part == ".." || part == ".git"; };
  if (place.empty() || place.is_absolute() || !place.has_extension() || std::ranges::any_of(place, isUp))
    refuse(place, "is not the name of a reference");
  core::expectNoLinkAbove(root / place, root);
  return root / place;
}

std::string digestIn(const json& file, const char* state) {
  const auto found = file.find(state);
  return found != file.end() && found->is_object() ? found->value("sha256", "") : "";
}

std::string digestOf(const std::string& content) { return core::toHex(core::sha256(content)); }

/// Returns the digest of a file; empty if the file does not exist.
std::string presentDigest(const fs::path& place) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(place, ignored);
  if (fs::is_symlink(status)) refuse(place, "is a link, which is not replaced");
  if (!fs::exists(status)) return "";
  return digestOf(core::readRegularFile(place, request::kMostPicture, core::ErrorKind::kIo));
}

/// Returns the new content of a file: a text, a picture of the page, or a file beside the page.
std::string contentOf(const json& row, const json& file, const fs::path& page) {
  if (file.contains("text")) return file.value("text", "");
  constexpr std::string_view kDataUrl = "data:image/png;base64,";
  const std::string picture = row.contains("actual") && row["actual"].is_string() ? row.value("actual", "") : "";
  if (file.value("embedded", false) && picture.starts_with(kDataUrl))
    return core::fromBase64(std::string_view(picture).substr(kDataUrl.size()));
  return core::readRegularFile(page.parent_path() / file.value("source", ""), request::kMostPicture,
                               core::ErrorKind::kIo);
}

void addFile(core::FileBatch& batch, const json& row, const json& file, const fs::path& page,
             const fs::path& root) {
  const fs::path place = placeOf(file, root);
  const std::string digest = digestIn(file, "new"), present = presentDigest(place);
  if (present == digest) return;  // approved earlier
  if (present != digestIn(file, "old"))
    refuse(place, "changed since the report was written; run the comparison again");
  if (digest.empty()) return batch.remove(place);
  const std::string content = contentOf(row, file, page);
  if (digestOf(content) != digest)
    refuse(page.parent_path() / file.value("source", ""),
           "is no longer the picture of the report; run the comparison again");
  core::makeFolders(place.parent_path());
  batch.write(place, content);
}

std::string lineOf(const json& row) {
  const std::string name = core::printable(row.value("name", ""));
  if (!row.contains("differing_pixels")) return fmt::format("{}: approved\n", name);
  return fmt::format("{}: approved, {} pixels changed, largest {:.4g}, FLIP mean {:.3g}, max {:.3g}\n", name,
                     row.value("differing_pixels", 0), row.value("max_difference", 0.0),
                     row.value("flip_mean", 0.0), row.value("flip_max", 0.0));
}

}  // namespace

std::string approveOnPage(core::FileBatch& batch, const fs::path& page, const std::vector<std::string>& names,
                          const fs::path& root) try {
  const json data = dataOf(page);
  std::string text;
  for (const json* row : meantRows(data, names, page)) {
    for (const json& file : (*row)["files"]) addFile(batch, *row, file, page, root);
    text += lineOf(*row);
  }
  return text;
} catch (const json::exception&) {
  refuse(page, "has damaged data; write it again with --report");
}

}  // namespace poinsot::compare
