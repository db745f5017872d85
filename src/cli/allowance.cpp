// SPDX-License-Identifier: Apache-2.0
#include "cli/allowance.h"

#include <fmt/format.h>

#include <system_error>

#include "cli/command.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "core/error.h"
#include "core/text.h"
#include "process/interrupt.h"

namespace poinsot::cli {
namespace {

using scene::Limit;

/// Calls `set`. If `set` throws an error, adds the option's name to the message.
template <class Set>
void setBy(const std::string& option, Set set) {
  try {
    set();
  } catch (const core::Error& error) {
    throw core::Error(error.kind(), fmt::format("{}: {}", option, error.message()));
  }
}

/// Rejects a path that exists but is not a folder. Allows a missing folder, which contains no files.
void expectFolder(const std::string& word) {
  std::error_code ignored;
  if (std::filesystem::is_directory(word, ignored) || !std::filesystem::exists(word, ignored)) return;
  throw core::usageError(fmt::format("--asset-root {}: not a folder", core::printable(word)));
}

}  // namespace

void addLimitOptions(const Command& command, AllowanceOptions& options) {
  command.option("--limit", options.limits, "raise or lower a limit, such as side=16384 (docs/scene.md, Limits)")
      .type("NAME=VALUE")
      .repeats();
  command
      .option("--max-memory", options.memory,
              "refuse a run if one of its processes is estimated to need more memory (default: 2GiB)")
      .type("SIZE")
      .notEmpty();
  command.option("--max-seconds", options.seconds, "stop after N seconds, with exit code 2")
      .type("N")
      .range(std::int64_t{1}, scene::rowOf(Limit::kSeconds).highest);
  command.flag("--untrusted", options.untrusted,
               "for files from strangers: run in a sandbox that can read only these files, write only the output, "
               "and use no network and no other programs (Linux)");
}

void addAllowance(const Command& command, AllowanceOptions& options) {
  addLimitOptions(command, options);
  command.option("--asset-root", options.assetRoots, "additional folder from which a scene may load files")
      .type("FOLDER")
      .repeats()
      .notEmpty();
}

scene::Allowance allowed(const AllowanceOptions& options) {
  scene::Allowance allowance;
  scene::Limits& limits = allowance.limits;
  for (const std::string& word : options.limits) setBy("--limit", [&] { limits.setByWord(word); });
  if (!options.memory.empty())
    setBy("--max-memory", [&] { limits.set(Limit::kMemory, std::string_view(options.memory)); });
  if (options.seconds > 0) limits.set(Limit::kSeconds, options.seconds);
  for (const std::string& word : options.assetRoots) {
    expectFolder(word);
    allowance.assetRoots.emplace_back(word);
  }
  return allowance;
}

scene::Allowance granted(const AllowanceOptions& options) {
  scene::Allowance allowance = allowed(options);
  const std::int64_t seconds = allowance.limits[Limit::kSeconds];
  if (seconds > 0) process::limitTime(seconds, kBadInput);
  return allowance;
}

std::vector<std::string> allowanceWords(const AllowanceOptions& options) {
  std::vector<std::string> words;
  for (const std::string& text : options.limits) words.insert(words.end(), {"--limit", text});
  for (const std::string& folder : options.assetRoots) words.insert(words.end(), {"--asset-root", folder});
  if (!options.memory.empty()) words.insert(words.end(), {"--max-memory", options.memory});
  return words;
}

}  // namespace poinsot::cli
