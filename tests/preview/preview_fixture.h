// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <httplib.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#undef _res  // a macro of <resolv.h>, which httplib.h brings; Eigen has arguments of that name

#include "preview/preview_server.h"
#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot::preview {

using nlohmann::json;

inline constexpr const char* kScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 3, 0.1]\n[time]\nduration = 2\n"
    "[output]\nsize = [320, 180]\n";

/// Preview of kScene that runs in this process.
class Preview : public testing::Test {
 protected:
  explicit Preview(std::vector<std::string> overrides = {}) {
    gl::pinEnvironment(false);
    folder_.put("a.toml", kScene);
    server_ = std::make_unique<PreviewServer>(PreviewRequest{
        .fileName = (folder_ / "a.toml").string(), .overrides = std::move(overrides), .allowance = {}});
    running_ = std::thread([this] { server_->run(); });
    const std::string address = server_->address();
    root_ = address.substr(address.find('/', 8));
  }
  ~Preview() override {
    server_->stop();
    running_.join();
  }

  httplib::Client client() const {
    httplib::Client made("127.0.0.1", server_->port());
    made.set_read_timeout(60, 0);
    return made;
  }
  httplib::Result get(const std::string& what) const { return client().Get(root_ + what); }
  json scene(int after) const { return json::parse(get("scene?after=" + std::to_string(after))->body); }
  std::string picture(int frame, const std::string& more = "") const {
    const auto answer = get("picture?width=320&height=180&frame=" + std::to_string(frame) + more);
    EXPECT_EQ(answer->status, 200) << answer->body;
    return answer->body;
  }
  /// Checks that a PNG has the picture of `poinsot still`, or of another command. Texts in the files are not
  /// compared.
  void expectSamePicture(const std::string& png, const std::string& words,
                         const std::string& command = "still") const {
    folder_.put("preview.png", png);
    const auto made = runShell(folder_.path(), POINSOT_PROGRAM " " + command + " a.toml -o still.png " + words +
                                                   " && " POINSOT_PROGRAM " diff --exact still.png preview.png");
    EXPECT_EQ(made.exitCode, 0) << made.out;
  }

  /// Replaces a file at once, as editors do, so that nobody sees half of a file on a slow machine.
  void save(const std::string& name, const std::string& text) const {
    std::filesystem::rename(folder_.put(name + "~", text), folder_ / name);
  }

  ScratchFolder folder_;
  std::unique_ptr<PreviewServer> server_;
  std::thread running_;
  std::string root_;
};

}  // namespace poinsot::preview
