// SPDX-License-Identifier: Apache-2.0
#include "app/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"

namespace poinsot::app {
namespace {

/// For the content of an element. A log of CI is read on a terminal, too.
std::string xml(std::string_view text) {
  std::string out;
  for (const char c : core::printableLines(text)) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// For an attribute, in which an end of line would become a blank.
std::string attribute(std::string_view text) {
  std::string out;
  for (const char c : xml(text)) out += c == '\n' ? std::string("&#10;") : std::string(1, c);
  return out;
}

std::string line(const char* term, const std::string& text) {
  return text.empty() ? "" : fmt::format("{:<10} {}\n", term, text);
}

/// Where the pictures are, and what to do.
std::string bodyOf(const Outcome& outcome, const OutcomeReport& report) {
  return line("approved", outcome.reference.native()) + line("new", outcome.actual.native()) +
         line("map", outcome.map.native()) + line("page", report.page.native()) +
         line("approve by", approveCommand({outcome}, report));
}

std::string attachmentsOf(const Outcome& outcome) {
  std::string text;
  for (const auto* file : {&outcome.reference, &outcome.actual, &outcome.map})
    if (!file->empty()) text += fmt::format("[[ATTACHMENT|{}]]\n", file->native());
  return text;
}

std::string caseXml(const Outcome& outcome, const OutcomeReport& report) {
  const std::string head = fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                                       attribute(report.suite), attribute(outcome.name), outcome.seconds);
  if (outcome.passes(report.exact)) return head + "/>\n";
  const char* kind = outcome.status == OutcomeStatus::kError ? "error" : "failure";
  const std::string attachments = attachmentsOf(outcome);
  return fmt::format(
      "{}>\n    <{} type=\"{}\" message=\"{}\">{}</{}>\n{}  </testcase>\n", head, kind, toString(outcome.status),
      attribute(outcome.message.empty() ? "not identical" : outcome.message), xml(bodyOf(outcome, report)), kind,
      attachments.empty() ? "" : fmt::format("    <system-out>{}</system-out>\n", xml(attachments)));
}

}  // namespace

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

}  // namespace poinsot::app
