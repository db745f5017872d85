// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"
#include "cli/option_values.h"
#include "cli/render_options.h"
#include "compare/picture_rule.h"
#include "core/error.h"
#include "fuzz/input.h"
#include "reference/trajectory_target.h"
#include "request/frame_plan.h"
#include "request/output_target.h"

namespace {

using namespace poinsot;

template <class Parse>
void attempt(const Parse& parse) {
  try {
    parse();
  } catch (const core::Error& error) {
    fuzz::expectPrintable(error.what());
  }
}

/// Calls every parser of option values that commands use.
void readValue(const std::string& word) {
  attempt([&] { request::parseTarget(word); });
  attempt([&] { request::parseStillTarget(word); });
  attempt([&] { reference::parseTrajectoryTarget(word); });
  attempt([&] { request::parseFrameRange(word); });
  attempt([&] { request::parseShard(word); });
  attempt([&] { cli::parseSize(word, scene::Limits()); });
  attempt([&] { cli::parseTimes_s("--at", word); });
  compare::NearRule rule;
  for (const compare::RuleLimit& limit : compare::ruleLimits())
    attempt([&] { limit.set(rule, limit.option, word); });
  attempt([&] { compare::ignoredBox("--ignore", word); });
}

}  // namespace

// The input is the words after the program's name, one on each line. No command runs.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> words = fuzz::wordsOf({data, size}, '\n');
  attempt([&] { const cli::CommandLine line(words); });
  readValue(words.back());
  return 0;
}
