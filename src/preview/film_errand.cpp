// SPDX-License-Identifier: Apache-2.0
#include "preview/film_errand.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.h"
#include "core/program_path.h"
#include "core/text.h"

namespace poinsot::preview {
namespace {

[[noreturn]] void refuseFilm(int why) {
  throw core::graphicsError("cannot start a process: " + core::systemReason(why));
}

/// Starts poinsot in a new process, with `errors` as standard error. Its standard input and output are /dev/null.
pid_t startProgram(const std::vector<std::string>& words, int errors) {
  const std::string program = core::programPath();
  std::vector<std::string> all{"poinsot"};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
  pid_t process = -1;
  const int why = posix_spawn(&process, program.c_str(), &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (why != 0) refuseFilm(why);
  return process;
}

void take(const std::string& line, FilmState& state) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) {
    state.text += (state.text.empty() ? "" : "\n") + core::printable(line);
    return;
  }
  state.done = json.value("done", state.done);
  state.total = json.value("total", state.total);
}

}  // namespace

FilmErrand::~FilmErrand() {
  stop();
  if (follower_.joinable()) follower_.join();
}

bool FilmErrand::start(const std::vector<std::string>& words, std::vector<std::string> changes) {
  const std::scoped_lock lock(mutex_);
  if (state_.stage == FilmState::Stage::kMaking) return false;
  if (follower_.joinable()) follower_.join();
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) refuseFilm(errno);
  const core::FileHandle errors(ends[1]);
  core::FileHandle ours(ends[0]);
  process_ = startProgram(words, errors.get());
  state_ = {.stage = FilmState::Stage::kMaking, .done = 0, .total = 0, .text = {}, .changes = std::move(changes)};
  follower_ = std::thread([this, from = std::move(ours)] { follow(from); });
  return true;
}

void FilmErrand::stop() {
  const std::scoped_lock lock(mutex_);
  if (state_.stage == FilmState::Stage::kMaking) kill(process_, SIGINT);
}

FilmState FilmErrand::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

void FilmErrand::follow(const core::FileHandle& errors) {
  std::string line;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(errors.get(), buffer.data(), buffer.size())) != 0;) {
    if (count < 0 && errno != EINTR) break;
    for (ssize_t i = 0; i < count; ++i) {
      if (buffer[static_cast<std::size_t>(i)] != '\n') {
        line += buffer[static_cast<std::size_t>(i)];
        continue;
      }
      const std::scoped_lock lock(mutex_);
      take(line, state_);
      line.clear();
    }
  }
  // The lock keeps stop() from sending a signal to the process ID, which is free after waitpid().
  const std::scoped_lock lock(mutex_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  state_.stage = good ? FilmState::Stage::kReady : FilmState::Stage::kFailed;
}

}  // namespace poinsot::preview
