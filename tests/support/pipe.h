// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/file_handle.h"

namespace poinsot {

struct Pipe {
  core::FileHandle read, write;
  Pipe() {
    int ends[2];
    if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    read = core::FileHandle(ends[0]);
    write = core::FileHandle(ends[1]);
  }
};

}  // namespace poinsot
