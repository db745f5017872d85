// SPDX-License-Identifier: Apache-2.0
#include "compare/outcome_page.h"

#include <algorithm>
#include <variant>

#include "compare/file_diff.h"
#include "compare/magma.h"
#include "compare/run_facts.h"
#include "core/parallel.h"
#include "core/shell_word.h"
#include "image/png_file.h"

namespace poinsot::compare {
namespace {

std::string textOf(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

std::string pngOf(const image::AnyImage& picture) {
  return textOf(std::visit([](const auto& p) { return image::encodePng(p); }, picture));
}

/// Reports whether a browser can show the file as a picture; false for films.
bool isPicture(const std::filesystem::path& file) { return image::isPngName(file); }

/// Embeds the pictures of a row. A map that has no name yet is read from its temporary file.
void embedFilesOf(DiffPageEntry& entry, const OutcomePageHead& head) {
  const std::filesystem::path map = entry.map.file;
  if (head.unnamed != nullptr) entry.map.file = head.unnamed->contentOf(map);
  embedFiles(entry);
  if (!entry.map.file.empty()) entry.map.file = map;
}

/// Embeds an outcome's pictures, if they are readable. Compares films, and pictures without a map file, again to
/// get a map.
void embed(DiffPageEntry& entry, const Outcome& outcome, const OutcomePageHead& head) try {
  const bool film = outcome.diff.film.has_value();
  if (!film) embedFilesOf(entry, head);
  if (!entry.hasFigures || (!film && !entry.map.png.empty())) return;
  const DiffRequest request{outcome.rule, head.pixelsPerDegree};
  const ComparedPictures compared = compareFiles(outcome.reference, outcome.actual, request);
  if (film)
    embedCompared(entry, compared);
  else
    entry.map.png = textOf(image::encodePng(magmaPicture(compared.flip)));
} catch (const core::Error&) {  // such as a file that changed after the comparison
  entry.map = {};
}

}  // namespace

DiffPage pageOf(const OutcomePageHead& head) {
  DiffPage page{head.title, head.verdict, head.reference, head.actual, head.entry, head.note};
  page.file = head.page;
  page.run = runFacts(head.place);
  page.approve = head.approve;
  page.root = approvalRoot(head.place);
  return page;
}

DiffPageEntry entryOf(const Outcome& outcome, const OutcomePageHead& head) {
  DiffPageEntry entry{outcome.name, std::string(toString(outcome.status)), outcome.message, outcome.diff};
  entry.hasFigures = outcome.diff.hasFigures;
  entry.pixelsPerDegree = head.pixelsPerDegree;
  for (const std::string& note : outcome.diff.notes) entry.facts.emplace_back("note", note);
  entry.facts.insert(entry.facts.end(), {{head.reference, outcome.reference.native()},
                                         {head.actual, outcome.actual.native()},
                                         {"renderer", outcome.origin.renderer}});
  if (isPicture(outcome.reference)) entry.reference.file = outcome.reference;
  if (isPicture(outcome.actual) && outcome.status != OutcomeStatus::kIdentical) entry.actual.file = outcome.actual;
  entry.map.file = outcome.map;
  if (isToApprove(outcome, head.exact)) {
    entry.approve = approvalWord(outcome.name);
    entry.approval = outcome.approval;
  }
  return entry;
}

void embedCompared(DiffPageEntry& entry, const ComparedPictures& compared) {
  entry.reference.png = pngOf(compared.reference.pixels);
  entry.actual.png = pngOf(compared.test.pixels);
  if (compared.diff.hasFigures) entry.map.png = textOf(image::encodePng(magmaPicture(compared.flip)));
}

std::string outcomePage(const std::vector<Outcome>& outcomes, const OutcomePageHead& head, int jobs) {
  DiffPage page = pageOf(head);
  for (const Outcome& outcome : outcomes) page.entries.push_back(entryOf(outcome, head));
  const auto order = worstFirst(page.entries);
  EmbedBudget budget;
  for (std::size_t done = 0; done < order.size() && !budget.isSpent();) {
    const std::size_t count = std::min(static_cast<std::size_t>(jobs), order.size() - done);
    core::forEachIndex(count, jobs, [&](std::size_t i) {
      DiffPageEntry* const entry = order[done + i];
      embed(*entry, outcomes[static_cast<std::size_t>(entry - page.entries.data())], head);
    });
    for (std::size_t i = 0; i < count; ++i) budget.admit(*order[done + i]);
    done += count;
  }
  return htmlOf(page);
}

}  // namespace poinsot::compare
