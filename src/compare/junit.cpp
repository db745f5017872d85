// SPDX-License-Identifier: Apache-2.0
#include "compare/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"

namespace poinsot::compare {
namespace {

/// Escapes text for an XML element. Control characters are replaced, because CI logs are shown on terminals.
std::string xml(std::string_view text) { return core::xmlAttribute(core::printableLines(text)); }

/// Escapes text for an XML attribute. Line ends are escaped too, because XML turns them into blanks there.
std::string attribute(std::string_view text) {
  std::string out;
  for (const char c : xml(text)) out += c == '\n' ? std::string("&#10;") : std::string(1, c);
  return out;
}

std::string line(const char* term, const std::string& text) {
  return text.empty() ? "" : fmt::format("{:<10} {}\n", term, text);
}

/// Returns the text of a failure: the reason, the paths of the pictures and the command that approves them. The
/// text repeats the reason, because GitLab does not show the failure's message.
std::string bodyOf(const Outcome& outcome, const OutcomeReport& report) {
  return reasonOf(outcome) + "\n" + line("approved", outcome.reference.native()) +
         line("new", outcome.actual.native()) + line("map", outcome.map.native()) +
         line("page", report.page.native()) + line("approve by", approveCommand({outcome}, report));
}

/// Returns the path of an attachment: relative to the root if the file lies below the root, otherwise absolute.
std::filesystem::path attachmentPath(const std::filesystem::path& file, const std::filesystem::path& root) {
  const auto path = std::filesystem::absolute(file).lexically_normal();
  if (root.empty()) return path;
  const auto below = path.lexically_relative(std::filesystem::absolute(root).lexically_normal());
  return below.empty() || *below.begin() == ".." ? path : below;
}

/// Lists the attachments of a test. The new picture is first, because GitLab shows only the first attachment.
std::string attachmentsOf(const Outcome& outcome, const std::filesystem::path& root) {
  std::string text;
  for (const auto* file : {&outcome.actual, &outcome.map, &outcome.reference})
    if (!file->empty()) text += fmt::format("[[ATTACHMENT|{}]]\n", attachmentPath(*file, root).native());
  return text;
}

/// Returns the end of a passed test's element. The reason of a near picture goes to system-out, because only
/// failures have a message.
std::string passedEnd(const Outcome& outcome) {
  if (outcome.message.empty()) return "/>\n";
  return fmt::format(">\n    <system-out>{}: {}</system-out>\n  </testcase>\n", toString(outcome.status),
                     xml(outcome.message));
}

std::string caseXml(const Outcome& outcome, const OutcomeReport& report) {
  const std::string head = fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                                       attribute(report.suite), attribute(outcome.name), outcome.seconds);
  if (outcome.passes(report.exact)) return head + passedEnd(outcome);
  const char* kind = outcome.status == OutcomeStatus::kError ? "error" : "failure";
  const std::string attachments = attachmentsOf(outcome, report.attachmentRoot);
  return fmt::format(
      "{}>\n    <{} type=\"{}\" message=\"{}\">{}</{}>\n{}  </testcase>\n", head, kind, toString(outcome.status),
      attribute(reasonOf(outcome)), xml(bodyOf(outcome, report)), kind,
      attachments.empty() ? "" : fmt::format("    <system-out>{}</system-out>\n", xml(attachments)));
}

constexpr const char* kJunitMark = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- poinsot";

}  // namespace

output::FileKind junitKind() { return output::textKind("a JUnit report", kJunitMark); }

std::string junitXml(const std::vector<Outcome>& outcomes, const OutcomeReport& report) {
  const auto count = [&](bool errors) {
    return std::ranges::count_if(outcomes, [&](const Outcome& o) {
      return !o.passes(report.exact) && (o.status == OutcomeStatus::kError) == errors;
    });
  };
  double seconds = 0;
  std::string cases;
  for (const Outcome& outcome : outcomes) {
    seconds += outcome.seconds;
    cases += caseXml(outcome, report);
  }
  return fmt::format(
      "{} -->\n<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
      "errors=\"{}\" time=\"{:.3f}\">\n{}</testsuite>\n",
      kJunitMark, attribute(report.suite), outcomes.size(), count(false), count(true), seconds, cases);
}

}  // namespace poinsot::compare
