// SPDX-License-Identifier: Apache-2.0
#include "cli/variables.h"

#include <algorithm>
#include <string_view>

#include "core/environment.h"

namespace poinsot::cli {
namespace {

constexpr Variable kVariables[] = {
    {"POINSOT_SCENES", "folder of the scenes that poinsot gallery shows, in place of the installed ones"},
    {"POINSOT_CACHE",
     "absolute path of the folder where compiled shaders are kept, or off; else XDG_CACHE_HOME/poinsot or "
     "~/.cache/poinsot"},
    {"POINSOT_SHADERS", "folder of shaders in place of those in the program, to work on them"},
    {"HOME", "where .cache/poinsot and .config/poinsot are"},
    {"XDG_CACHE_HOME", "folder for poinsot/, with compiled shaders, in place of ~/.cache"},
    {"XDG_CONFIG_HOME", "folder of poinsot/defaults.toml, in place of ~/.config"},
    {"TMPDIR", "folder for temporary files, in place of /tmp"},
    {"CI", "unless empty, 0 or false: golden and diff approve nothing"},
    {"GITHUB_STEP_SUMMARY", "file that --markdown may add to, whatever its name is"},
    {"CI_PROJECT_DIR", "folder that the paths of attachments in JUnit reports start from"},
    {"NO_COLOR", "no colour in messages on a terminal"},
    {"TERM", "dumb: no colour and no progress line on a terminal"},
    {"TZ", "time zone of the date in reports"},
    {"USER", "name in the ssh command that preview prints"},
    {"SSH_CONNECTION", "address in the ssh command that preview prints"},
};

bool isReadBeforeMain(std::string_view name) { return name.starts_with("LD_") || name.ends_with("SAN_OPTIONS"); }

}  // namespace

std::span<const Variable> variables() { return kVariables; }

void clearOtherVariables() {
  core::clearEnvironment([](std::string_view name) {
    return isReadBeforeMain(name) ||
           std::ranges::any_of(kVariables, [&](const Variable& known) { return name == known.name; });
  });
}

}  // namespace poinsot::cli
