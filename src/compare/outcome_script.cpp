// SPDX-License-Identifier: Apache-2.0
#include "compare/outcome_script.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>

namespace poinsot::compare {
namespace {

using nlohmann::ordered_json;

std::string nowText() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

constexpr const char* kCall = "poinsotOutcome(";
constexpr const char* kMark = "poinsotOutcome({";

std::string callOf(const ordered_json& json) {
  return kCall + json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + ");\n";
}

ordered_json pageOf(const OutcomeReport& report, const std::filesystem::path& script) {
  if (report.page.empty()) return nullptr;
  return std::filesystem::absolute(report.page)
      .lexically_relative(std::filesystem::absolute(script).parent_path())
      .native();
}

/// Returns the reason of the first failure and the number of other failures, such as "sphere: largest difference
/// 230 (limit 2); 2 more". Leaves out the name if there is only one test.
std::string reasonOf(const std::vector<Outcome>& outcomes, const Outcome& first, std::ptrdiff_t failures) {
  const std::string reason = reasonOf(first);
  if (outcomes.size() == 1) return reason;
  return fmt::format("{}: {}{}", first.name, reason, failures > 1 ? fmt::format("; {} more", failures - 1) : "");
}

std::string_view passedVerdict(const std::vector<Outcome>& outcomes) {
  const bool near =
      std::ranges::any_of(outcomes, [](const Outcome& o) { return o.status == OutcomeStatus::kNear; });
  return toString(near ? OutcomeStatus::kNear : OutcomeStatus::kIdentical);
}

}  // namespace

output::FileKind outcomeScriptKind() { return output::textKind("an outcome script", kMark); }

std::string outcomeScript(const std::vector<Outcome>& outcomes, const OutcomeReport& report,
                          const std::filesystem::path& script) {
  const auto failure = std::ranges::find_if(outcomes, [&](const Outcome& o) { return !o.passes(report.exact); });
  const bool passed = failure == outcomes.end();
  return callOf({{"verdict", passed ? passedVerdict(outcomes) : toString(failure->status)},
                 {"passed", passed},
                 {"counts", countsText(outcomes)},
                 {"message", passed ? "" : reasonOf(outcomes, *failure, countFailures(outcomes, report.exact))},
                 {"page", pageOf(report, script)},
                 {"finished", nowText()}});
}

std::string brokenOutcomeScript(const std::string& message) {
  return callOf({{"verdict", toString(OutcomeStatus::kError)},
                 {"passed", false},
                 {"counts", ""},
                 {"message", message},
                 {"page", nullptr},
                 {"finished", nowText()}});
}

}  // namespace poinsot::compare
