// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/offscreen_context.h"
#include "request/user_files.h"
#include "scene/limits.h"

namespace poinsot::preview {

struct PreviewRequest {
  std::string fileName;
  std::vector<std::string> overrides;  ///< values of -D
  scene::Allowance allowance;
  std::vector<std::string> filmWords = {};  ///< more arguments for the process that makes the film
  request::UnitChoice units = {};           ///< units of the physics
  gl::Backend backend = gl::Backend::kAuto;
  int port = 0;  ///< 0 chooses a free port
};

/// Shows a scene in a browser on this machine: pictures of the renderer that makes the films, a time line,
/// numbers, and mistakes as they are made. The address holds a secret token; requests without the token are
/// refused.
class PreviewServer {
 public:
  /// Starts to listen. @throws core::Error(kIo) if the port is taken.
  explicit PreviewServer(const PreviewRequest& request);
  ~PreviewServer();

  int port() const;
  /// Returns "http://127.0.0.1:8437/q8Zx.../".
  std::string address() const;

  void run();
  /// Ends run(). Any thread may call this function.
  void stop();

 private:
  class Site;
  std::unique_ptr<Site> site_;
};

}  // namespace poinsot::preview
