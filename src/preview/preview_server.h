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
  std::vector<std::string> overrides;  ///< overrides from -D
  scene::Allowance allowance;
  std::vector<std::string> filmWords = {};  ///< additional arguments for making the film
  request::UnitChoice units = {};           ///< units for the physics
  gl::Backend backend = gl::Backend::kAuto;
  int port = 0;  ///< 0 selects a free port
};

/// HTTP server that shows a scene in a browser on this machine. The page shows pictures as in the film, a time
/// line, physical quantities, and errors while the user edits the scene. The address contains a secret token.
/// Requests without the token are rejected.
class PreviewServer {
 public:
  /// Binds the port. @throws core::Error(kIo) if the port is already in use.
  explicit PreviewServer(const PreviewRequest& request);
  ~PreviewServer();

  int port() const;
  /// Returns the address of the page, such as "http://127.0.0.1:8437/q8Zx.../".
  std::string address() const;

  void run();
  /// Ends run(). Any thread may call this function.
  void stop();

 private:
  class Site;
  std::unique_ptr<Site> site_;
};

}  // namespace poinsot::preview
