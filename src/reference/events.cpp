// SPDX-License-Identifier: Apache-2.0
#include "reference/events.h"

#include <nlohmann/json.hpp>

#include "core/number.h"

namespace poinsot::reference {
namespace {

using Object = nlohmann::ordered_json;

constexpr const char* kCsvHead = "t,film_from,film_to,event\n";
constexpr const char* kEventsFormat = "poinsot events 1";

void appendTime(std::string& text, const std::optional<double>& time_s) {
  if (time_s)
    core::appendNumber(text, *time_s);
  else
    text += "nan";
  text += ',';
}

std::string csvText(const std::vector<scene::SceneEvent>& events) {
  std::string text = kCsvHead;
  for (const scene::SceneEvent& event : events) {
    appendTime(text, event.t_s);
    appendTime(text, event.film ? std::optional(event.film->from_s) : std::nullopt);
    appendTime(text, event.film ? std::optional(event.film->to_s) : std::nullopt);
    text += scene::eventKinds()[static_cast<std::size_t>(event.kind)].word;
    text += '\n';
  }
  return text;
}

/// Returns a number without the sign of a zero.
double plain(double value) { return value == 0 ? 0 : value; }

Object eventJson(const scene::SceneEvent& event) {
  return {{"t", plain(event.t_s)},
          {"film_from", event.film ? Object(plain(event.film->from_s)) : Object()},
          {"film_to", event.film ? Object(plain(event.film->to_s)) : Object()},
          {"event", scene::eventKinds()[static_cast<std::size_t>(event.kind)].word}};
}

std::string jsonText(const std::vector<scene::SceneEvent>& events, const std::string& sceneName) {
  Object all{{"format", kEventsFormat},
             {"scene", sceneName},
             {"units", {{"t", "s"}, {"film_from", "s"}, {"film_to", "s"}}},
             {"events", Object::array()}};
  for (const scene::SceneEvent& event : events) all["events"].push_back(eventJson(event));
  return all.dump(2, ' ', true, Object::error_handler_t::replace) + "\n";
}

}  // namespace

std::string eventsText(const std::vector<scene::SceneEvent>& events, TrajectoryFormat format,
                       const std::string& sceneName) {
  return format == TrajectoryFormat::kCsv ? csvText(events) : jsonText(events, sceneName);
}

output::FileKind eventsKind(TrajectoryFormat format) {
  return output::textKind("a list of events", format == TrajectoryFormat::kCsv
                                                  ? kCsvHead
                                                  : std::string("{\n  \"format\": \"") + kEventsFormat + '"');
}

}  // namespace poinsot::reference
