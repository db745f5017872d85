// SPDX-License-Identifier: Apache-2.0
#include "app/golden_junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"

namespace poinsot::app {
namespace {

/// Within quotes. A log of CI is read on a terminal, too.
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
    else if (c == '\n')
      out += "&#10;";
    else
      out += c;
  }
  return out;
}

std::string caseXml(const std::string& suite, const GoldenOutcome& outcome, bool exact) {
  const std::string head = fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", xml(suite),
                                       xml(outcome.name), outcome.seconds);
  if (outcome.passes(exact)) return head + "/>\n";
  const char* kind = outcome.status == GoldenStatus::kError ? "error" : "failure";
  return fmt::format("{}>\n    <{} type=\"{}\" message=\"{}\"/>\n  </testcase>\n", head, kind,
                     toString(outcome.status), xml(outcome.message.empty() ? "not identical" : outcome.message));
}

}  // namespace

std::string junitXml(const std::string& suite, const std::vector<GoldenOutcome>& outcomes, bool exact) {
  const auto count = [&](bool errors) {
    return std::ranges::count_if(outcomes, [&](const GoldenOutcome& o) {
      return !o.passes(exact) && (o.status == GoldenStatus::kError) == errors;
    });
  };
  double seconds = 0;
  std::string cases;
  for (const GoldenOutcome& outcome : outcomes) {
    seconds += outcome.seconds;
    cases += caseXml(suite, outcome, exact);
  }
  return fmt::format(
      "{}<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" "
      "errors=\"{}\" time=\"{:.3f}\">\n{}</testsuite>\n",
      kJunitMark, xml(suite), outcomes.size(), count(false), count(true), seconds, cases);
}

}  // namespace poinsot::app
