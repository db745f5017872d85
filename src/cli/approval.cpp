// SPDX-License-Identifier: Apache-2.0
#include "cli/approval.h"

#include <cstdlib>
#include <string_view>

#include "core/error.h"

namespace poinsot::cli {

namespace {

[[noreturn]] void refuse(const char* message) { throw core::usageError(message); }

}  // namespace

void expectMayApprove(const AllowanceOptions& options) {
  if (options.untrusted) refuse("--update: nothing that is not trusted is approved");
  const char* ci = std::getenv("CI");
  if (ci && *ci && std::string_view(ci) != "0" && std::string_view(ci) != "false")
    refuse("--update: nothing is approved where the environment says CI; look at the pictures first");
}

std::filesystem::path attachmentRoot() {
  const char* folder = std::getenv("CI_PROJECT_DIR");
  return folder ? folder : "";
}

}  // namespace poinsot::cli
