// SPDX-License-Identifier: Apache-2.0
#include "core/shared_library.h"

#include <dlfcn.h>
#include <link.h>

namespace poinsot::core {
namespace {

/// Returns "libX.so.1 cannot be opened: REASON". Names the package to install only if a file is missing, because
/// installing does not help against other reasons, such as lack of memory. @param reason  from dlerror()
std::string whyNotOpened(const std::string& soname, const std::string& package, std::string reason) {
  if (reason.starts_with(soname + ": ")) reason.erase(0, soname.size() + 2);
  const bool missing = reason.find("No such file") != std::string::npos;
  return soname + " cannot be opened: " + reason +
         (missing ? "; install it with: apt-get install " + package : "");
}

}  // namespace

SharedLibrary::SharedLibrary(const char* soname, const char* package, ErrorKind kind)
    : soname_(soname), kind_(kind), handle_(dlopen(soname, RTLD_NOW | RTLD_LOCAL)) {
  if (!handle_) throw Error(kind, whyNotOpened(soname, package, dlerror()));
}

bool SharedLibrary::isOpen(const char* soname) {
  void* const handle = dlopen(soname, RTLD_NOLOAD | RTLD_LAZY);
  if (handle) dlclose(handle);  // undoes the reference count of the dlopen above
  return handle != nullptr;
}

std::filesystem::path SharedLibrary::file() const {
  const link_map* found = nullptr;
  return dlinfo(handle_, RTLD_DI_LINKMAP, &found) == 0 ? found->l_name : "";
}

void* SharedLibrary::address(const char* name) const { return dlsym(handle_, name); }

}  // namespace poinsot::core
