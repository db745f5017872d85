// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/error.h"

namespace poinsot::cli {

/// What the program ends with; 128 + n besides, for signal n.
enum ExitCode : int {
  kDone = 0,
  kNo = 1,        ///< the answer is no
  kBadInput = 2,  ///< usage, the scene or a file it names, a limit
  kFailed = 3,    ///< rendering, encoding, back end, memory
  kBadFile = 4,   ///< output, files named on the command line
  kBrokenPipe = 141,
};

/// The same in words, for people.
constexpr const char* kExitCodesText =
    "0 done, 1 the answer is no, 2 usage, scene or limit, 3 rendering or encoding,\n"
    "  4 files, 129/130/143 signals, 141 broken pipe.";

/// The one place where kinds of errors become exit codes.
ExitCode exitCodeOf(core::ErrorKind kind);

/// Does it, and says on stderr what it throws. @returns its exit status, or that of what it threw.
int translatingErrors(const std::function<int()>& action);

}  // namespace poinsot::cli
