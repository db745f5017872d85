// SPDX-License-Identifier: Apache-2.0
#include "suite/approval.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/folder.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "image/pixel_digest.h"
#include "image/png_file.h"
#include "job/segment_record.h"
#include "output/film_reader.h"
#include "request/picture_options.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refusePlace(const fs::path& place, const std::string& owner, const std::string& renderer) {
  throw core::usageError(
      fmt::format("{}: is the reference of {}; the reference of '{}' would have the same file name, so choose "
                  "another variant",
                  core::printable(place.native()), owner, core::printable(renderer)));
}

/// Returns the file to which a new reference is written.
/// @throws core::Error(kUsage) if the file belongs to another renderer or test.
fs::path placeOf(const std::vector<GoldenReference>& there, const std::string& renderer, const GoldenName& name,
                 const fs::path& usual, bool beside) {
  for (const GoldenReference& reference : there)
    if (reference.origin.renderer == renderer) return reference.picture;
  if (!beside || there.empty()) return usual;
  const fs::path place = fileFor(renderer, usual);
  if (name.taken.contains(place.stem()))
    refusePlace(place, fmt::format("the test '{}'", (fs::path(name.name).parent_path() / place.stem()).native()),
                renderer);
  if (!isDescription(descriptionOf(place))) return place;
  const std::string other = describedOrigin(place).renderer;
  if (other != renderer) refusePlace(place, fmt::format("'{}'", core::printable(other)), renderer);
  return place;
}

/// Copies the new picture of an outcome to a temporary file.
/// @throws core::Error(kIo) if the copy's pixels differ from the pixels that were compared
core::AtomicFile copyOf(const compare::Outcome& outcome, const fs::path& place) {
  core::AtomicFile file(place);
  file.write(core::readRegularFile(outcome.actual, request::kMostPicture, core::ErrorKind::kIo));
  if (pixelDigestOf(file.temporary(), output::isFilm(outcome.actual)) != outcome.pixels)
    throw core::ioError(
        fmt::format("{}: is no longer the picture that was compared; nothing was approved: run again",
                    core::printable(outcome.actual.native())));
  return file;
}

std::string originText(const compare::PictureOrigin& origin) {
  const nlohmann::ordered_json json{{"renderer", origin.renderer},
                                    {"driver", origin.driver},
                                    {"software", origin.software},
                                    {"scene", origin.scene}};
  return json.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string pixelDigestOf(const fs::path& file, bool isFilm) {
  return isFilm ? job::recordOf(file).sha256 : image::pixelDigest(image::readPngAsStored(file).picture);
}

void enterApproval(output::RunFiles& files, const fs::path& place) {
  static const output::FileKind reference{"a reference", [](const fs::path&) { return true; }};
  static const output::FileKind description{"a description of a reference", isDescription};
  files.writesInNewFolder(place, "--update", reference);
  files.writesInNewFolder(descriptionOf(place), "--update", description);
}

Approval GoldenApproval::planned(const GoldenName& name, const compare::PictureOrigin& origin) const {
  const fs::path usual = usualFile(references_, name);
  core::expectNoLinkAbove(usual, references_);
  const auto there = referencesOf(references_, name);
  Approval approval{placeOf(there, origin.renderer, name, usual, beside_), {}};
  if (beside_) return approval;
  const bool isOwn =
      std::ranges::any_of(there, [&](const GoldenReference& r) { return r.origin.renderer == origin.renderer; });
  for (const GoldenReference& reference : there) {
    const bool holds = isOwn && !origin.scene.empty() && reference.origin.scene == origin.scene;
    if (reference.picture != approval.place && !holds) approval.removed.push_back(reference.picture);
  }
  return approval;
}

Approval GoldenApproval::add(const GoldenName& name, const compare::Outcome& outcome) {
  Approval approval = planned(name, outcome.origin);
  core::makeFolders(approval.place.parent_path());
  output::RunFiles files(force_);
  enterApproval(files, approval.place);
  batch_.add(copyOf(outcome, approval.place));
  batch_.writeBeside(descriptionOf(approval.place), originText(outcome.origin));
  for (const fs::path& picture : approval.removed) {
    batch_.removeBeside(picture);
    batch_.removeBeside(descriptionOf(picture));
  }
  return approval;
}

std::vector<compare::ApprovalFile> GoldenApproval::filesOf(const GoldenName& name,
                                                           const compare::Outcome& outcome) const {
  const Approval approval = planned(name, outcome.origin);
  std::vector<compare::ApprovalFile> files{{approval.place, outcome.actual},
                                           {descriptionOf(approval.place), {}, originText(outcome.origin)}};
  for (const fs::path& picture : approval.removed)
    files.insert(files.end(), {{picture}, {descriptionOf(picture)}});
  return files;
}

}  // namespace poinsot::suite
