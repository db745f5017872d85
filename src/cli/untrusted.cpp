// SPDX-License-Identifier: Apache-2.0
#include "cli/untrusted.h"

#include <CLI/CLI.hpp>

#include "app/supervisor.h"
#include "app/user_limits.h"
#include "cli/exit_code.h"
#include "output/atomic_file.h"

namespace poinsot::cli {
namespace {

// Of one process, beside the limits of a scene: room for all that these allow.
constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;
constexpr std::uint64_t kMostMemory_bytes = 8 * kGiB, kMostFile_bytes = 64 * kGiB, kMostCpu_s = 24 * 3600;

bool isFile(const std::string& name) { return !name.empty() && name != "-"; }

app::Confinement confinementOf(const Reach& reach) {
  app::Confinement confinement;
  app::Sandbox& sandbox = confinement.sandbox;
  for (const std::string& scene : reach.scenes) {
    sandbox.read.emplace_back(scene);  // may be a link to elsewhere
    sandbox.read.push_back(output::folderOf(scene));
  }
  for (const std::string& input : reach.inputs) sandbox.read.emplace_back(input);
  sandbox.read.push_back(app::userLimitsFile());  // the user's own
  for (const std::string& file : reach.outputs)
    if (isFile(file)) sandbox.write.push_back(output::folderOf(file));
  for (const std::string& folder : reach.made) {
    output::makeFolders(folder);
    sandbox.write.emplace_back(folder);
  }
  sandbox.mostMemory_bytes = kMostMemory_bytes;
  sandbox.mostFile_bytes = kMostFile_bytes;
  sandbox.mostCpu_s = kMostCpu_s;
  confinement.draws = reach.reproducible;
  return confinement;
}

}  // namespace

void addUntrusted(CLI::App& command, bool& untrusted) {
  command.add_flag(
      "--untrusted", untrusted,
      "of a stranger's files: in a sandbox that reads nothing but them, writes nothing but the output, and "
      "has no network and no other programs (Linux)");
}

int confined(bool untrusted, const std::function<Reach()>& reachOf, const std::function<int()>& work) {
  return untrusted ? app::runConfined(confinementOf(reachOf()), translatingErrors, work) : work();
}

}  // namespace poinsot::cli
