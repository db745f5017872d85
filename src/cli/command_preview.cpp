// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <poll.h>
#include <stdlib.h>

#include <cstdlib>
#include <memory>
#include <sstream>
#include <thread>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/render_options.h"
#include "cli/scene_options.h"
#include "core/error.h"
#include "core/shell_word.h"
#include "job/render_job.h"
#include "preview/preview_server.h"
#include "process/interrupt.h"
#include "request/scene_request.h"
#include "request/sweep_cells.h"
#include "scene/document/problem.h"

namespace poinsot::cli {
namespace {

struct PreviewOptions : SceneOptions {
  int port = 0;
};

class StopOnSignal {
 public:
  explicit StopOnSignal(preview::PreviewServer& server)
      : waiting_([&server](const std::stop_token& stop) {
          pollfd signal{.fd = process::interruptFd(), .events = POLLIN, .revents = 0};
          while (!stop.stop_requested() && process::interruptSignal() == 0) poll(&signal, 1, 100);
          server.stop();
        }) {}

 private:
  std::jthread waiting_;
};

/// Returns "USER@ADDRESS" of this machine, with the address that the ssh client connected to. Returns
/// "THIS_MACHINE" without ssh.
std::string thisMachine() {
  const char* const user = std::getenv("USER");
  // The value consists of client address, client port, server address and server port.
  const char* const connection = std::getenv("SSH_CONNECTION");
  if (!user || !connection) return "THIS_MACHINE";
  std::istringstream words(connection);
  std::string theirs, theirPort, ours;
  words >> theirs >> theirPort >> ours;
  return ours.empty() ? "THIS_MACHINE" : core::shellWord(fmt::format("{}@{}", user, ours));
}

/// Prints mistakes in a scene, but lets the preview start. Throws if the file cannot be read.
void tellMistakes(const PreviewOptions& options) {
  auto request = request::readSceneRequest(options.scene, options.overrides, granted(options));
  request::askForSweep(request);
  try {
    request::loadRequested(request);
  } catch (const scene::SceneErrors& errors) {
    writeErr(
        fmt::format("{}\n"
                    "poinsot: the page shows these errors too, and the scene as soon as they are fixed\n",
                    errors.what()));
  }
}

int preview(const PreviewOptions& options) {
  if (options.untrusted)  // because the sandbox has no network
    throw core::usageError("--untrusted: not possible with preview, which needs the network; use check or still");
  process::watchInterrupts();
  gl::pinEnvironment(false, job::availableCpus());
  tellMistakes(options);
  preview::PreviewServer server({.fileName = options.scene,
                                 .overrides = options.overrides,
                                 .allowance = granted(options),
                                 .filmWords = allowanceWords(options),
                                 .units = request::defaultsOf(request::userDefaultsFile()).units,
                                 .backend = gl::Backend::kAuto,
                                 .port = options.port});
  writeOut(
      fmt::format("{0}\n"
                  "Open this address in a browser on this machine. On another machine, first run\n"
                  "  ssh -L {1}:127.0.0.1:{1} {2}\n"
                  "there. --port {1} keeps the port number. Ctrl-C ends the preview.\n",
                  server.address(), server.port(), thisMachine()));
  {
    const StopOnSignal stopping(server);
    server.run();
  }
  return kDone;
}

}  // namespace

void addPreview(const Command& program) {
  auto options = std::make_shared<PreviewOptions>();
  const Command command =
      program.command("preview", "show a scene in the browser while you edit it, drawn like the film");
  addSceneOptions(command, *options);
  command.option("--port", options->port, "port to listen on (default: any free port)").type("N").range(1, 65535);
  command.footer(
      "Keys in the page: space plays, arrows step (with Shift a second), Home, End; ? lists all.\n"
      "Example:\n"
      "  poinsot preview book.toml");
  command.does({[options] { return preview(*options); }});
}

}  // namespace poinsot::cli
