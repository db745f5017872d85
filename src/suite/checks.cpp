// SPDX-License-Identifier: Apache-2.0
#include "suite/checks.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <system_error>

#include "core/error.h"
#include "core/file_names.h"
#include "core/text.h"
#include "output/film_reader.h"
#include "scene/document/problem.h"
#include "suite/files.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;

/// Returns the renderers that have approved references, for images with a variant. "" stands for an unknown
/// renderer.
std::set<std::string> approvedRenderers(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases) {
  std::set<std::string> renderers;
  for (const GoldenCase& one : cases) {
    if (one.variant().empty()) continue;
    try {
      for (const GoldenReference& reference : referencesOf(manifest.references, one.reference()))
        renderers.insert(reference.origin.renderer);
    } catch (const core::Error&) {  // the comparison of the case reports this error
    }
  }
  return renderers;
}

struct SuiteFile {
  fs::path file;
  const GoldenCase* of;
  const char* use;
};

std::string useText(const SuiteFile& file) {
  const GoldenTest& test = file.of->test;
  return fmt::format("{} of test '{}' (line {}{})", file.use, test.name, test.at.line, matchedText(test, ": "));
}

std::string sharedText(const SuiteFile& first, const SuiteFile& second) {
  const std::string file = core::printable(second.file.native());
  if (first.of == second.of)
    return fmt::format("test.image: {} would be {} and {}; give the image the extension of its format", file,
                       first.use, useText(second));
  if (first.of->test.name == second.of->test.name)
    return fmt::format("test.times: {} would be {} at two times; give each time once", file, useText(second));
  return fmt::format("test.name: {} would be {} and {}; choose other names or times", file, useText(first),
                     useText(second));
}

/// Index of all files of a suite. Reports an error if a file would have two uses, such as a reference and a new
/// picture.
class FileUses {
 public:
  FileUses(const fs::path& references, const fs::path& output) : references_(references), output_(output) {}

  /// Adds the files that a run does not write: references, images and masks. Tests may share images and masks.
  void addKept(const GoldenCase& one) {
    const fs::path usual = usualFile(references_, one.reference());
    addReference(one, usual);
    if (!one.variant().empty()) addReference(one, fileFor(one.variant(), usual));
    if (!one.test.image.empty()) addInput({one.actual, &one, "the image"});
    if (!one.test.rule.mask.empty()) addInput({one.test.rule.mask, &one, "the mask"});
  }

  /// Reports whether an image is its own reference. This is not reported here, but when the case is compared.
  static bool isOwn(const SuiteFile& input, const SuiteFile& reference) {
    return input.of == reference.of && input.file == input.of->actual;
  }

  /// Checks that approving a picture cannot overwrite an image or a mask. Call after the last addKept().
  void expectInputsApart() const {
    for (const auto& [name, input] : inputs_)
      if (const auto found = referenceFiles_.find(name);
          found != referenceFiles_.end() && !isOwn(input, found->second))
        throw scene::SceneErrors(
            {{input.of->test.at,
              fmt::format("{} is {} and would be {}, so approving would replace it; put it into another folder",
                          core::printable(input.file.native()), useText(input), useText(found->second)),
              "", 0, 0}});
  }

  void addWritten(const GoldenCase& one) {
    if (!one.test.scene.empty()) write({one.actual, &one, "the new picture"});
    write({one.fileIn(output_, kMapEnding), &one, "the FLIP map"});
    write({one.fileIn(output_, kDifferenceEnding), &one, "the difference"});
  }

 private:
  using Files = std::map<std::string, SuiteFile>;

  void addReference(const GoldenCase& one, const fs::path& picture) {
    add(referenceFiles_, {picture, &one, "the reference"});
    add(referenceFiles_, {descriptionOf(picture), &one, "the description"});
  }

  void addInput(const SuiteFile& file) {
    std::error_code ignored;  // inputs are only read, so links are allowed
    inputs_.try_emplace(names_.of(fs::weakly_canonical(file.file, ignored)), file);
  }

  void write(const SuiteFile& file) {
    expectKept(referenceFiles_, file);
    expectKept(inputs_, file);
    add(written_, file);
  }

  void add(Files& files, const SuiteFile& file) {
    const auto [first, isFree] = files.try_emplace(names_.of(file.file), file);
    if (!isFree) throw scene::SceneErrors({{file.of->test.at, sharedText(first->second, file), "", 0, 0}});
  }

  void expectKept(const Files& files, const SuiteFile& written) {
    const auto kept = files.find(names_.of(written.file));
    if (kept == files.end()) return;
    throw core::usageError(fmt::format("-o {}: {} would be {} and is {}; choose another folder",
                                       core::printable(output_.native()), core::printable(written.file.native()),
                                       useText(written), useText(kept->second)));
  }

  const fs::path &references_, &output_;
  core::FileNames names_;
  Files referenceFiles_, inputs_, written_;
};

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
    throw core::usageError(
        fmt::format("variant '{}': has no approved reference; {}; to approve the first one, use {}",
                    core::printable(one.variant()),
                    known.empty() ? "no reference has a variant"
                                  : fmt::format("known variants: {}", core::joined(known, ", ")),
                    approveBy));
  }
}

void enterPatterns(output::RunFiles& files, const GoldenManifest& manifest) {
  const GoldenTest* last = nullptr;  // the tests of a pattern follow one another
  for (const GoldenTest& test : manifest.tests) {
    if (!isPattern(test.file) || (last && last->at.line == test.at.line)) continue;
    last = &test;
    const bool isImage = test.scene.empty();
    files.readsMatching(
        [&test, isImage](const fs::path& file) {
          return (!isImage || output::isPictureOrFilmName(file)) && isMatch(test.folder, test.file, file);
        },
        fmt::format("{} '{}' (line {})", isImage ? "test.image" : "test.scene", core::printable(test.file),
                    test.at.line));
  }
}

void expectFilesApart(const GoldenManifest& manifest, const std::vector<GoldenCase>& cases,
                      const fs::path& output) {
  std::error_code ignored;
  if (fs::equivalent(output, manifest.references, ignored))
    throw core::usageError(fmt::format("-o {}: contains the approved references; choose another folder",
                                       core::printable(output.native())));
  FileUses uses(manifest.references, output);
  for (const GoldenCase& one : cases)
    if (!one.test.isUnmatched) uses.addKept(one);
  uses.expectInputsApart();
  for (const GoldenCase& one : cases)
    if (!one.test.isUnmatched) uses.addWritten(one);
}

}  // namespace poinsot::suite
