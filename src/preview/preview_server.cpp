// SPDX-License-Identifier: Apache-2.0
#include "preview/preview_server.h"

#include <fmt/format.h>
#include <sys/random.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <semaphore>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base64.h"
#include "core/error.h"
#include "core/number.h"
#include "core/shell_word.h"
#include "preview/film_errand.h"
#include "preview/listener.h"
#include "preview/picture_press.h"
#include "preview/preview_json.h"
#include "preview/program_words.h"
#include "preview/still_errand.h"
#include "preview/watched_scene.h"
#include "request/sweep_cells.h"

// Embedded content of the file page.html.
extern "C" const char poinsot_preview_page[];

namespace poinsot::preview {
namespace {

using httplib::Request;
using httplib::Response;

constexpr auto kLongestWait = std::chrono::seconds(20);
constexpr std::ptrdiff_t kMostWaiting = Listener::kThreads / 2;  // limit, because each page occupies a thread
constexpr int kLeastSide = 16, kMostSide = 4096;
constexpr std::size_t kMostOverrides = 64, kLongestOverride = 1000;

std::string randomToken() {
  std::array<std::uint8_t, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw core::ioError("cannot get random numbers from the system");
  std::string token;
  for (const std::uint8_t byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

/// Returns whether two tokens are equal. The time does not reveal at which character they differ.
bool isSame(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0u : 1u;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

/// Returns whether the Host header names this machine, with any port (for ssh -L). Rejects other names, even if
/// they resolve to this machine, because a website can use them for an attack (DNS rebinding).
bool isLocalName(std::string_view host) {
  constexpr std::string_view kNames[] = {"127.0.0.1", "localhost", "[::1]"};
  return std::ranges::any_of(kNames, [&](std::string_view name) {
    return host.starts_with(name) && (host.size() == name.size() || host[name.size()] == ':');
  });
}

std::optional<std::int64_t> number(const Request& request, const char* name) {
  return core::parseInteger<std::int64_t>(request.get_param_value(name));
}

void refuse(Response& response, int status, const std::string& why) {
  response.status = status;
  response.set_content(why + "\n", "text/plain; charset=utf-8");
}

std::optional<PageChanges> changesAsked(const Request& request, Response& response) {
  PageChanges changes;
  const std::size_t count = request.get_param_value_count("D");
  for (std::size_t i = 0; i < count && i < kMostOverrides; ++i)
    changes.overrides.push_back(request.get_param_value("D", i));
  const auto isLong = [](const std::string& word) { return word.size() > kLongestOverride; };
  if (count > kMostOverrides || std::ranges::any_of(changes.overrides, isLong)) {
    refuse(response, 400,
           fmt::format("at most {} keys can be changed, with {} bytes each", kMostOverrides, kLongestOverride));
    return std::nullopt;
  }
  if (const auto view = number(request, "view"); view && *view >= 0)
    changes.view = static_cast<std::size_t>(*view);
  return changes;
}

std::optional<PictureAsk> pictureAsk(const Request& request, Response& response) {
  const auto frame = number(request, "frame"), width = number(request, "width"),
             height = number(request, "height");
  const auto isSide = [](const std::optional<std::int64_t>& side) {
    return side && *side >= kLeastSide && *side <= kMostSide;
  };
  if (!frame || !isSide(width) || !isSide(height)) {
    refuse(response, 400,
           fmt::format("a picture needs a frame number, and sides from {} to {} pixels", kLeastSide, kMostSide));
    return std::nullopt;
  }
  auto changes = changesAsked(request, response);
  if (!changes) return std::nullopt;
  return PictureAsk{*frame, {static_cast<int>(*width), static_cast<int>(*height)}, std::move(*changes)};
}

/// Returns the changes as the page lists them, such as "style.theme="dark"" and "only view 2".
std::vector<std::string> toldChanges(const PageChanges& changes) {
  std::vector<std::string> told = changes.overrides;
  if (changes.view) told.push_back(fmt::format("only view {}", *changes.view + 1));
  return told;
}

/// Picture or figure that the browser saves.
struct StillAsk {
  StillFormat format;
  PageChanges changes;
  double time_s = 0;
  std::string name;  ///< file name without an ending

  std::string target() const { return name + std::string(format.target); }
  std::string file() const { return name + std::string(format.file); }
};

}  // namespace

class PreviewServer::Site {
 public:
  explicit Site(const PreviewRequest& request)
      : request_(request),
        token_(randomToken()),
        scene_(request.fileName, request.overrides, request.allowance),
        press_(scene_, request.backend) {
    configure();
    addRoutes();
    // Omits SO_REUSEPORT, which cpp-httplib sets by default, because another process could then share the port.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    port_ = request.port;
    const bool bound = request.port > 0 ? server_.bind_to_port("127.0.0.1", request.port)
                                        : (port_ = server_.bind_to_any_port("127.0.0.1")) > 0;
    if (!bound)
      throw core::ioError(
          fmt::format("--port {}: cannot be opened; another program may already use this port", request.port));
    server_.widen();
  }

  int port() const { return port_; }
  std::string address() const { return fmt::format("http://127.0.0.1:{}/{}/", port_, token_); }
  void run() { server_.serve(); }
  void stop() {
    scene_.stop();
    still_.stop();
    server_.end();
  }

 private:
  void configure() {
    server_.set_tcp_nodelay(true);
    server_.set_payload_max_length(64 << 10);
    server_.set_default_headers(
        {{"Cache-Control", "no-store"},
         {"X-Content-Type-Options", "nosniff"},
         {"Referrer-Policy", "no-referrer"},
         {"Content-Security-Policy",
          "default-src 'none'; img-src 'self' blob: data:; connect-src 'self'; style-src "
          "'unsafe-inline'; script-src 'unsafe-inline'; frame-ancestors 'none'; base-uri 'none'"}});
    server_.set_pre_routing_handler([this](const Request& request, Response& response) {
      if (isAllowed(request)) return httplib::Server::HandlerResponse::Unhandled;
      refuse(response, 403, "unknown address; copy the whole address that `poinsot preview` printed");
      return httplib::Server::HandlerResponse::Handled;
    });
  }

  bool isAllowed(const Request& request) const {
    const std::string_view path = request.path;
    const std::string_view first = path.substr(std::min<std::size_t>(1, path.size()), path.find('/', 1) - 1);
    return isLocalName(request.get_header_value("Host")) && isSame(first, token_);
  }

  void addRoutes() {
    const std::string root = "/" + token_;
    server_.Get(root + "/", [](const Request&, Response& response) {
      response.set_content(poinsot_preview_page, "text/html; charset=utf-8");
    });
    server_.Get(root + "/scene", [this](const Request& request, Response& response) { scene(request, response); });
    server_.Get(root + "/picture",
                [this](const Request& request, Response& response) { picture(request, response); });
    server_.Get(root + "/series",
                [this](const Request& request, Response& response) { series(request, response); });
    server_.Get(root + "/still", [this](const Request& request, Response& response) { still(request, response); });
    server_.Get(root + "/still/command",
                [this](const Request& request, Response& response) { stillCommand(request, response); });
    server_.Get(root + "/film",
                [this](const Request&, Response& response) { json(response, filmJson(film_.state())); });
    server_.Post(root + "/film", [this](const Request& request, Response& response) { film(request, response); });
    server_.Post(root + "/film/stop", [this](const Request&, Response& response) {
      film_.stop();
      json(response, filmJson(film_.state()));
    });
  }

  static void json(Response& response, const std::string& text) { response.set_content(text, "application/json"); }

  /// Responds when the scene changes, or after kLongestWait. Does not wait if kMostWaiting pages already wait.
  void scene(const Request& request, Response& response) {
    const auto known = static_cast<int>(number(request, "after").value_or(-1));
    const bool mayWait = places_.try_acquire();
    const SceneVersion version = scene_.after(known, mayWait ? kLongestWait : std::chrono::seconds(0));
    if (mayWait) places_.release();
    if (!mayWait && version.number <= known)
      return refuse(response, 503, "too many pages are open; try again later");
    json(response, sceneJson(version, request_.units));
  }

  void picture(const Request& request, Response& response) {
    const auto ask = pictureAsk(request, response);
    if (!ask) return;
    try {
      response.set_content(press_.png(*ask), "image/png");
    } catch (const core::Error& error) {
      refuse(response, 422, error.what());
    }
  }

  void series(const Request& request, Response& response) {
    const SceneVersion version = scene_.now();
    if (!version.scene) return refuse(response, 422, version.error);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(request.get_param_value_count("name"), 8); ++i)
      names.push_back(request.get_param_value("name", i));
    try {
      json(response, seriesJson(*version.scene, names));
    } catch (const core::Error& error) {
      refuse(response, 422, error.what());
    }
  }

  /// Returns the path for the film of a sweep, named like the pictures of `sweep`. Creates the folder, because
  /// `sweep` does not create the folder of a given path.
  std::string sweepFilm() const {
    std::error_code ignored;  // ignored: the process that makes the film reports a missing folder
    std::filesystem::create_directory("out", ignored);
    return "out/" + std::filesystem::path(request_.fileName).stem().string() + "_sweep.mp4";
  }

  void film(const Request& request, Response& response) {
    const auto changes = changesAsked(request, response);
    if (!changes) return;
    const std::string target = request::hasRanges(request_.overrides) ? sweepFilm() : "";
    try {
      film_.start(filmWords(request_, *changes, target), toldChanges(*changes));
      json(response, filmJson(film_.state()));
    } catch (const core::Error& error) {
      refuse(response, 500, error.what());
    }
  }

  std::optional<StillAsk> stillAsk(const Request& request, Response& response) const {
    const StillFormat* const format = stillFormat(request.get_param_value("format"));
    const auto frame = number(request, "frame");
    if (!format || !frame) {
      refuse(response, 400, "a still needs a frame number, and a format: png, pdf, svg, tex or tex-image");
      return std::nullopt;
    }
    auto changes = changesAsked(request, response);
    if (!changes) return std::nullopt;
    const SceneVersion version = scene_.now();
    if (!version.scene) {
      refuse(response, 422, version.error);
      return std::nullopt;
    }
    const double time_s = frameTime_s(*version.scene, *frame);
    return StillAsk{*format, std::move(*changes), time_s, stillName(request_, time_s)};
  }

  /// Sends a file that `still` makes. Leaves no file on this machine.
  void still(const Request& request, Response& response) {
    const auto ask = stillAsk(request, response);
    if (!ask) return;
    try {
      const auto bytes = still_.make(ask->target(), ask->file(), [&](const std::string& target) {
        return stillWords(request_, ask->changes, ask->time_s, target);
      });
      if (!bytes) return refuse(response, 503, "another picture is still in progress; try again when it is saved");
      response.set_header("Content-Disposition", fmt::format("attachment; filename=\"{}\"", ask->file()));
      response.set_content(*bytes, std::string(ask->format.type));
    } catch (const core::Error& error) {
      refuse(response, 422, error.what());
    }
  }

  /// Sends the command that makes the same file in the folder out/.
  void stillCommand(const Request& request, Response& response) {
    const auto ask = stillAsk(request, response);
    if (!ask) return;
    const auto words = stillWords(request_, ask->changes, ask->time_s, "out/" + ask->target());
    response.set_content("poinsot " + core::shellWords(words), "text/plain; charset=utf-8");
  }

  const PreviewRequest request_;
  const std::string token_;
  int port_ = 0;
  WatchedScene scene_;
  PicturePress press_;
  FilmErrand film_;
  StillErrand still_;
  std::counting_semaphore<> places_{kMostWaiting};
  Listener server_;  // declared last, because its threads use the other members
};

PreviewServer::PreviewServer(const PreviewRequest& request) : site_(std::make_unique<Site>(request)) {}
PreviewServer::~PreviewServer() = default;
int PreviewServer::port() const { return site_->port(); }
std::string PreviewServer::address() const { return site_->address(); }
void PreviewServer::run() { site_->run(); }
void PreviewServer::stop() { site_->stop(); }

}  // namespace poinsot::preview
