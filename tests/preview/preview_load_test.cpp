// SPDX-License-Identifier: Apache-2.0
// The preview when other clients demand more than the server has.
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <new>
#include <string_view>

#include "core/error.h"
#include "core/file_handle.h"
#include "preview/pending_connections.h"
#include "preview/preview_fixture.h"

namespace poinsot::preview {
namespace {

/// Connection that sends given bytes and reads nothing.
class Stranger {
 public:
  explicit Stranger(int port, std::string words) : words_(std::move(words)), port_(port) {}

  /// Sends the next bytes; reconnects if the other side has hung up.
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
  /// Returns how long the slowest of four small answers takes: the least of three attempts, because other
  /// processes may delay one. A connection that must wait for a thread, or be retried, takes seconds in each
  /// attempt.
  double slowestAnswer_s() const {
    double least = 1e9;
    for (int attempt = 0; attempt < 3 && least >= 1; ++attempt) {
      double slowest = 0;
      for (int i = 0; i < 4; ++i) slowest = std::max(slowest, answer_s());
      least = std::min(least, slowest);
    }
    return least;
  }

 private:
  double answer_s() const {
    const auto begin = std::chrono::steady_clock::now();
    const auto answer = get("film");
    EXPECT_TRUE(answer && answer->status == 200);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
};

// Each kind has more connections than there are threads. A page promises to answer within a second.
TEST_F(PreviewUnderLoad, AnswersWhileOtherClientsAreSlow) {
  const std::string head = "GET / HTTP/1.1\r\nHost: localhost\r\nX-Long: ";
  const std::string kinds[] = {
      head + std::string(60000, 'a'),                                        // never ends
      "",                                                                    // sends nothing
      head + "\r\n\r\n",                                                     // one request, then stays connected
      "POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 60000\r\n\r\n" + head,  // has a slow body
      "\r\n\r\n\r\n",
      std::string("\0\xff\r\n\r\n", 6)};
  std::vector<Stranger> strangers;
  for (const std::string& kind : kinds)
    for (int i = 0; i < 80; ++i) strangers.emplace_back(server_->port(), kind);
  std::atomic<bool> done = false;
  std::thread sending([&] {
    for (Stranger& one : strangers) one.send(200);  // the heads of requests
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

TEST(PendingConnections, ClosesAConnectionIfAcceptingItFails) {
  std::promise<void> admitted;
  int count = 0;
  PendingConnections pending([&](const core::FileHandle&) {
    if (++count == 1) throw std::bad_alloc();
    admitted.set_value();
  });
  const auto connect = [&] {
    int ends[2];
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    pending.add(core::FileHandle(ends[0]));
    EXPECT_EQ(::send(ends[1], "\r\n\r\n", 4, MSG_NOSIGNAL), 4);
    return core::FileHandle(ends[1]);
  };
  const auto refused = connect();
  char byte = 0;
  EXPECT_LE(::recv(refused.get(), &byte, 1, 0), 0) << "the other side has hung up";
  const auto other = connect();
  EXPECT_EQ(admitted.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

TEST(PreviewServerTest, ReportsThatNoMoreFilesCanBeOpened) {
  const ScratchFolder folder;
  folder.put("a.toml", kScene);
  PreviewServer server(PreviewRequest{.fileName = (folder / "a.toml").string(), .overrides = {}, .allowance = {}});
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit none = before;
  none.rlim_cur = 0;  // fewer than are open
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  EXPECT_THROW(server.run(), core::Error);
  EXPECT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
}

}  // namespace
}  // namespace poinsot::preview
