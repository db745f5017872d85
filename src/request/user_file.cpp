// SPDX-License-Identifier: Apache-2.0
#include "request/user_file.h"

#include <cstdlib>
#include <system_error>

#include "core/regular_file.h"

namespace poinsot::request {
namespace {

namespace fs = std::filesystem;

/// Of an environment variable; empty unless it is an absolute path, as the XDG specification has it.
fs::path folderNamed(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path folder = value ? value : "";
  return folder.is_absolute() ? folder : fs::path();
}

}  // namespace

fs::path userFile(std::string_view name) {
  fs::path folder = folderNamed("XDG_CONFIG_HOME");
  if (const fs::path home = folderNamed("HOME"); folder.empty() && !home.empty()) folder = home / ".config";
  return folder.empty() ? folder : folder / "poinsot" / name;
}

void readUserFile(const fs::path& file, const std::function<void(const scene::Entry&, scene::Problems&)>& take) {
  std::error_code ignored;  // what cannot even be looked for is not there
  if (file.empty() || !fs::exists(file, ignored)) return;
  const std::size_t most = scene::Limits().bytes(scene::Limit::kSceneBytes);
  const scene::Source source(file.string(), core::readRegularFile(file, most, core::ErrorKind::kIo));
  scene::Problems problems;
  const scene::Node document = parseDocument(source);
  for (const scene::Entry& entry : *document.as<scene::Node::Table>()) take(entry, problems);
  problems.throwIfAny();
}

}  // namespace poinsot::request
