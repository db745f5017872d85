// SPDX-License-Identifier: Apache-2.0
#include "cli/exit_code.h"

#include <fmt/format.h>

#include <new>

#include "cli/console.h"
#include "process/interrupt.h"
#include "scene/document/problem.h"

namespace poinsot::cli {
namespace {

/// Calls `action` and prints any error except lack of memory. @throws std::bad_alloc
int tellingErrors(const std::function<int()>& action) {
  try {
    return action();
  } catch (const core::BrokenPipe&) {
    return kBrokenPipe;
  } catch (const process::Interrupted& interrupted) {
    return 128 + interrupted.signal();
  } catch (const scene::SceneErrors& errors) {
    writeErr(fmt::format("{}\n", errors.what()));  // the text already begins with "file:line:column: error:"
    return exitCodeOf(errors.kind());
  } catch (const core::Error& error) {
    writeError(error.what());
    return exitCodeOf(error.kind());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    writeError(error.what());
    return kFailed;
  }
}

}  // namespace

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

int translatingErrors(const std::function<int()>& action) {
  try {
    return tellingErrors(action);
  } catch (const std::bad_alloc&) {  // memory may have run out while another error was printed
    writeOutOfMemory();
    return kFailed;
  }
}

}  // namespace poinsot::cli
