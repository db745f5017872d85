// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/error.h"

namespace poinsot::cli {

/// Exit code of the program. If signal n ends the program, the code is 128 + n.
enum ExitCode : int {
  kDone = 0,
  kNo = 1,        ///< no error, but the answer is no: for example, pictures differ
  kBadInput = 2,  ///< error in the command line, the scene or its files; exceeded limit
  kFailed = 3,    ///< error in rendering, encoding or OpenGL; lack of memory
  kBadFile = 4,   ///< error with an output or with a file on the command line
  kBrokenPipe = 141,
};

constexpr const char* kExitCodesText =
    "0 done, 1 the answer is no, 2 usage, scene or limit, 3 rendering or encoding,\n"
    "  4 files, 129/130/143 signals, 141 broken pipe.";

/// Returns the exit code for a kind of error. Every error gets its exit code here.
ExitCode exitCodeOf(core::ErrorKind kind);

/// Calls `action`. If it throws, prints the error on stderr. @returns the exit code of the action or of the error
int translatingErrors(const std::function<int()>& action);

}  // namespace poinsot::cli
