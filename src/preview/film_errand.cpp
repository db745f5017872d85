// SPDX-License-Identifier: Apache-2.0
#include "preview/film_errand.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/text.h"

namespace poinsot::preview {
namespace {

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
  run_ = std::make_unique<ProgramRun>(words);
  state_ = {.stage = FilmState::Stage::kMaking, .done = 0, .total = 0, .text = {}, .changes = std::move(changes)};
  follower_ = std::thread([this] { follow(); });
  return true;
}

void FilmErrand::stop() {
  const std::scoped_lock lock(mutex_);
  if (state_.stage == FilmState::Stage::kMaking) run_->interrupt();
}

FilmState FilmErrand::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

void FilmErrand::follow() {
  const bool good = run_->wait([this](const std::string& line) {
    const std::scoped_lock lock(mutex_);
    take(line, state_);
  });
  const std::scoped_lock lock(mutex_);
  state_.stage = good ? FilmState::Stage::kReady : FilmState::Stage::kFailed;
}

}  // namespace poinsot::preview
