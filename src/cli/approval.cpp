// SPDX-License-Identifier: Apache-2.0
#include "cli/approval.h"

#include <cstdlib>
#include <string>
#include <string_view>

#include "core/error.h"

namespace poinsot::cli {

namespace {

[[noreturn]] void refuse(const char* what, const char* message) {
  throw core::usageError(std::string(what) + ": " + message);
}

}  // namespace

void expectMayApprove(const AllowanceOptions& options, const char* what) {
  if (options.untrusted)
    refuse(what, "not possible with --untrusted, because untrusted pictures are never approved");
  const char* ci = std::getenv("CI");
  if (ci && *ci && std::string_view(ci) != "0" && std::string_view(ci) != "false")
    refuse(what,
           "not possible while the environment variable CI is set; look at the pictures first, then "
           "approve them outside CI");
}

std::filesystem::path attachmentRoot() {
  const char* folder = std::getenv("CI_PROJECT_DIR");
  return folder ? folder : "";
}

}  // namespace poinsot::cli
