// SPDX-License-Identifier: Apache-2.0
// The preview while others want more of it than there is.
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <string_view>

#include "core/file_handle.h"
#include "preview/preview_fixture.h"

namespace poinsot::preview {
namespace {

/// A connection that sends what it is told and reads nothing.
class Stranger {
 public:
  explicit Stranger(int port, std::string words) : words_(std::move(words)), port_(port) {}

  /// Sends the next bytes; begins anew where the other side has hung up.
  void send(std::size_t count) {
    if (!socket_) connect();
    const std::string_view next = std::string_view(words_).substr(std::min(sent_, words_.size()), count);
    const ssize_t written = ::send(socket_.get(), next.data(), next.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    char byte = 0;
    const bool gone = written < 0 || ::recv(socket_.get(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
    sent_ += gone ? 0 : next.size();
    if (gone) socket_.reset();
  }

 private:
  void connect() {
    socket_ = core::FileHandle(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    sent_ = 0;
  }

  std::string words_;
  int port_;
  core::FileHandle socket_;
  std::size_t sent_ = 0;
};

class PreviewUnderLoad : public Preview {
 protected:
  /// Of a small answer, the longest of several.
  double slowestAnswer_s() const {
    double slowest = 0;
    for (int i = 0; i < 4; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      const auto answer = get("film");
      EXPECT_TRUE(answer && answer->status == 200);
      slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return slowest;
  }
};

// Each kind by more connections than there are threads. That a page answers within a second is the promise.
TEST_F(PreviewUnderLoad, AnswersWhileStrangersAreSlow) {
  const std::string head = "GET / HTTP/1.1\r\nHost: localhost\r\nX-Long: ";
  const std::string kinds[] = {
      head + std::string(60000, 'a'),                                        // never ends
      "",                                                                    // says nothing
      head + "\r\n\r\n",                                                     // asks once, and stays
      "POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 60000\r\n\r\n" + head,  // has a slow body
      "\r\n\r\n\r\n",
      std::string("\0\xff\r\n\r\n", 6)};
  std::vector<Stranger> strangers;
  for (const std::string& kind : kinds)
    for (int i = 0; i < 80; ++i) strangers.emplace_back(server_->port(), kind);
  std::atomic<bool> done = false;
  std::thread sending([&] {
    for (Stranger& one : strangers) one.send(200);  // the head of those that have one
    while (!done) {
      for (Stranger& one : strangers) one.send(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_LT(slowestAnswer_s(), 1);
  done = true;
  sending.join();
  EXPECT_LT(slowestAnswer_s(), 1);
}

TEST_F(PreviewUnderLoad, AnswersWhilePagesWaitForAChange) {
  const std::string known = std::to_string(scene(-1)["version"].get<int>());
  std::vector<Stranger> pages;
  for (int i = 0; i < 200; ++i)
    pages.emplace_back(server_->port(),
                       "GET " + root_ + "scene?after=" + known + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
  for (Stranger& page : pages) page.send(1000);
  EXPECT_LT(slowestAnswer_s(), 1);
  EXPECT_EQ(get("scene?after=" + known)->status, 503);
  EXPECT_EQ(get("scene?after=0")->status, 200) << "what is there already waits for nothing";
}

}  // namespace
}  // namespace poinsot::preview
