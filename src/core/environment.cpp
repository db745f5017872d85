// SPDX-License-Identifier: Apache-2.0
#include "core/environment.h"

#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace poinsot::core {

void clearEnvironment(const std::function<bool(std::string_view name)>& isKept) {
  std::vector<std::string> cleared;  // names collected first, because unsetenv() moves the entries
  for (char** setting = environ; setting && *setting; ++setting) {
    const std::string_view name = std::string_view(*setting).substr(0, std::string_view(*setting).find('='));
    if (!isKept(name)) cleared.emplace_back(name);
  }
  for (const std::string& name : cleared) unsetenv(name.c_str());
}

}  // namespace poinsot::core
