// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/error.h"

namespace poinsot::cli {

/// Exit code of the program. After signal n the code is 128 + n.
enum ExitCode : int {
  kDone = 0,
  kNo = 1,        ///< no error, but the answer is no
  kBadInput = 2,  ///< error in the arguments, in the scene or a file that it names, or a limit is exceeded
  kFailed = 3,    ///< error in rendering, encoding or the back end, or memory ran out
  kBadFile = 4,   ///< error with an output, or with a file named on the command line
  kBrokenPipe = 141,
};

constexpr const char* kExitCodesText =
    "0 done, 1 the answer is no, 2 usage, scene or limit, 3 rendering or encoding,\n"
    "  4 files, 129/130/143 signals, 141 broken pipe.";

/// Returns the exit code of an error. No other function assigns exit codes to kinds of errors.
ExitCode exitCodeOf(core::ErrorKind kind);

/// Calls `action`, and prints its exception on stderr. @returns the exit status of the action or of the exception
int translatingErrors(const std::function<int()>& action);

}  // namespace poinsot::cli
