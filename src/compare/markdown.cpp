// SPDX-License-Identifier: Apache-2.0
#include "compare/markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/text.h"

namespace poinsot::compare {
namespace {

/// Escapes text for one line of Markdown. Special characters become entities, so that the text makes no links or
/// mentions.
std::string plain(std::string_view text) {
  constexpr std::string_view kSpecial = "\\`*_{}[]()<>#+-.!|~&@:/";
  std::string out;
  for (const char c : core::printable(text)) {
    if (kSpecial.find(c) == std::string_view::npos)
      out += c;
    else
      out += fmt::format("&#{};", static_cast<int>(c));
  }
  return out;
}

/// Returns a fenced code block. The fence is longer than any run of backticks in the code.
std::string codeBlock(const std::string& code) {
  std::size_t run = 0, longest = 2;
  for (const char c : code) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  const std::string fence(longest + 1, '`');
  return fmt::format("{}sh\n{}\n{}\n", fence, code, fence);
}

std::string rowOf(const Outcome& outcome) {
  const ImageDifference& d = outcome.diff.figures;
  const std::string figures = outcome.diff.hasFigures ? fmt::format("{:.4g} | {} | {:.3g} | {:.3g}", d.maxAbs,
                                                                    d.differingPixels, d.flip.mean, d.flip.max)
                                                      : std::string(" | | | ");
  return fmt::format("| {} | {} | {} | {} |\n", toString(outcome.status), plain(outcome.name),
                     plain(reasonOf(outcome)), figures);
}

std::string tableOf(const std::vector<Outcome>& outcomes, const OutcomeReport& report) {
  constexpr std::ptrdiff_t kMost = 50;
  std::string rows;
  std::ptrdiff_t shown = 0;
  for (const Outcome& outcome : outcomes)
    if (!outcome.passes(report.exact) && shown++ < kMost) rows += rowOf(outcome);
  if (shown > kMost) rows += fmt::format("\n{} more are not in the table.\n", shown - kMost);
  return "| verdict | test | why | largest | pixels | FLIP mean | FLIP max |\n"
         "| --- | --- | --- | ---: | ---: | ---: | ---: |\n" +
         rows;
}

bool isMarkdown(const std::filesystem::path& file) {
  std::error_code ignored;
  const char* summary = std::getenv("GITHUB_STEP_SUMMARY");
  return file.extension() == ".md" || (summary && std::filesystem::equivalent(file, summary, ignored));
}

}  // namespace

const output::FileKind& markdownKind() {
  static const output::FileKind kind{"a NAME.md, or the file that GITHUB_STEP_SUMMARY names", isMarkdown};
  return kind;
}

std::string markdownOf(const std::vector<Outcome>& outcomes, const OutcomeReport& report) {
  const auto failures = countFailures(outcomes, report.exact);
  std::string text = fmt::format("### {}: {}\n\n{}\n", plain(report.suite), failures == 0 ? "passed" : "failed",
                                 countsText(outcomes));
  if (failures == 0) return text;
  text += "\n" + tableOf(outcomes, report);
  if (!report.page.empty()) text += fmt::format("\nPictures: {}\n", plain(report.page.native()));
  const std::string approve = approveCommand(outcomes, report);
  if (!approve.empty()) text += "\nTo approve the new pictures, look at them and run\n\n" + codeBlock(approve);
  return text;
}

}  // namespace poinsot::compare
