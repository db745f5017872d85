// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

/// Reading whole files that come from anywhere.
namespace poinsot::scene {

/// Owns a file descriptor; closes it on every way out.
class OpenFile {
 public:
  explicit OpenFile(int handle) : handle_(handle) {}
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&& other) noexcept;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int handle() const { return handle_; }
  explicit operator bool() const { return handle_ >= 0; }

 private:
  int handle_;
};

/// At most one byte more than `most`, which is enough to refuse the file.
/// @throws core::Error(kScene) saying only why: it is a directory, it is not a regular file, it cannot be read.
std::string textOf(const OpenFile& file, std::size_t most);

}  // namespace poinsot::scene
