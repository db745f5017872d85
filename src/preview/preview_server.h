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
  std::vector<std::string> overrides;  ///< after -D
  scene::Allowance allowance;
  std::vector<std::string> filmWords = {};  ///< besides file and overrides, for what makes the film
  request::UnitChoice units = {};           ///< that the physics is told in
  gl::Backend backend = gl::Backend::kAuto;
  int port = 0;  ///< 0: any that is free
};

/// Shows a scene in a browser on this machine: pictures drawn by the renderer that makes the films, a time line,
/// the numbers, mistakes as they are made. Only who knows the address, which holds a token, is answered.
class PreviewServer {
 public:
  /// Begins to listen. @throws core::Error(kIo) if the port is taken.
  explicit PreviewServer(const PreviewRequest& request);
  ~PreviewServer();

  int port() const;
  /// "http://127.0.0.1:8437/q8Zx.../".
  std::string address() const;

  /// Answers until stop().
  void run();
  /// From any thread.
  void stop();

 private:
  class Site;
  std::unique_ptr<Site> site_;
};

}  // namespace poinsot::preview
