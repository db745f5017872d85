// SPDX-License-Identifier: Apache-2.0
#include "cli/variables.h"

#include <algorithm>
#include <string_view>

#include "core/environment.h"

namespace poinsot::cli {
namespace {

constexpr Variable kVariables[] = {
    {"POINSOT_SCENES", "folder of the scenes that poinsot gallery shows, instead of the installed ones"},
    {"POINSOT_CACHE",
     "absolute path of the folder for compiled shaders, or off (default: XDG_CACHE_HOME/poinsot or "
     "~/.cache/poinsot)"},
    {"POINSOT_SHADERS", "folder of shaders that replace the built-in ones, for work on shaders"},
    {"HOME", "folder that contains .cache/poinsot and .config/poinsot"},
    {"XDG_CACHE_HOME", "folder for poinsot/, with compiled shaders, instead of ~/.cache"},
    {"XDG_CONFIG_HOME", "folder of poinsot/defaults.toml, instead of ~/.config"},
    {"TMPDIR", "folder for temporary files, instead of /tmp"},
    {"CI", "unless empty, 0 or false: golden and diff approve nothing"},
    {"GITHUB_STEP_SUMMARY", "file that --markdown may append to, regardless of its name"},
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
