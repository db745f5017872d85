// SPDX-License-Identifier: Apache-2.0
#include "cli/exit_code.h"

namespace poinsot::cli {

ExitCode exitCodeOf(core::ErrorKind kind) {
  switch (kind) {
    case core::ErrorKind::kUsage:
    case core::ErrorKind::kScene:
    case core::ErrorKind::kLimit:
    case core::ErrorKind::kPhysics:
      return kBadInput;
    case core::ErrorKind::kGraphics:
    case core::ErrorKind::kEncode:
      return kFailed;
    case core::ErrorKind::kIo:
      return kBadFile;
  }
  return kFailed;
}

}  // namespace poinsot::cli
