// SPDX-License-Identifier: Apache-2.0
#include "core/kernel_start.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/sha256.h"

namespace poinsot::core {
namespace {

std::string readKernelStart() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string line;
  std::getline(file, line);
  return line;
}

std::string readProcessSpace() {
  constexpr std::size_t kDigits = 12;
  std::error_code failure;
  const auto numbers = std::filesystem::read_symlink("/proc/self/ns/pid", failure);
  if (failure || kernelStart().empty()) return "";
  return toHex(sha256(kernelStart() + numbers.native())).substr(0, kDigits);
}

}  // namespace

const std::string& kernelStart() {
  static const std::string start = readKernelStart();
  return start;
}

const std::string& processSpace() {
  static const std::string space = readProcessSpace();
  return space;
}

}  // namespace poinsot::core
