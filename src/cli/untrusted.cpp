// SPDX-License-Identifier: Apache-2.0
#include "cli/untrusted.h"

#include "cli/exit_code.h"
#include "core/atomic_file.h"
#include "gl/shader_cache.h"
#include "process/supervisor.h"
#include "request/user_files.h"

namespace poinsot::cli {
namespace {

using scene::Limit;

// Bytes of address space per byte of allowed memory. OpenGL drivers reserve address space that they never use.
constexpr std::uint64_t kAddressSpace = 4;
// Limit on CPU time for a run without --max-seconds.
constexpr std::uint64_t kMostCpu_s = std::uint64_t{24} * 3600;

bool isFile(const std::string& name) { return !name.empty() && name != "-"; }

process::Confinement confinementOf(const FileAccess& access, const scene::Limits& limits) {
  process::Confinement confinement;
  process::Sandbox& sandbox = confinement.sandbox;
  for (const std::string& scene : access.scenes) {
    sandbox.read.emplace_back(scene);  // listed itself, because it may be a link into another folder
    sandbox.read.push_back(core::folderOf(scene));
  }
  for (const std::string& input : access.inputs) sandbox.read.emplace_back(input);
  sandbox.read.push_back(request::userDefaultsFile());
  for (const std::string& file : access.outputs)
    if (isFile(file)) sandbox.write.push_back(core::folderOf(file));
  for (const std::string& folder : access.made) {
    core::makeFolders(folder);
    sandbox.write.emplace_back(folder);
  }
  sandbox.mostMemory_bytes = kAddressSpace * limits.bytes(Limit::kMemory);
  sandbox.mostFile_bytes = limits.bytes(Limit::kOutput);
  sandbox.mostCpu_s = limits[Limit::kSeconds] > 0 ? limits.bytes(Limit::kSeconds) : kMostCpu_s;
  if (access.reproducible) confinement.shaderCache = gl::shaderCacheFolder(*access.reproducible);
  return confinement;
}

}  // namespace

int confined(const AllowanceOptions& options, const std::function<FileAccess()>& accessOf,
             const std::function<int()>& work) {
  if (!options.untrusted) return work();
  return process::runConfined(confinementOf(accessOf(), allowed(options).limits), translatingErrors, work);
}

}  // namespace poinsot::cli
