// SPDX-License-Identifier: Apache-2.0
#include "job/worker_protocol.h"

#include <nlohmann/json.hpp>

#include "core/json.h"

namespace poinsot::job {
namespace {

using Message = nlohmann::json;

std::string textOf(const Message& json) { return core::bytesFromUtf8(json.get<std::string>()); }

Message toJson(const request::FrameRange& frames) { return Message{frames.first, frames.last}; }

request::FrameRange rangeOf(const Message& json) {
  return {json.at(0).get<std::int64_t>(), json.at(1).get<std::int64_t>()};
}

// In the order of the fields, so that the two functions below stay readable side by side.
Message toJson(const Statistics& s) {
  Message steps = Message::array();
  for (std::size_t i = 0; i < core::kSteps; ++i) steps.push_back(s.steps[static_cast<core::Step>(i)]);
  return Message{s.frames, s.workers, s.first_s, steps, s.cpu_s, s.peakMemory_bytes};
}

Statistics statisticsOf(const Message& json) {
  const auto count = [&](std::size_t i) { return json.at(i).get<std::int64_t>(); };
  const auto number = [&](std::size_t i) { return json.at(i).get<double>(); };
  core::StepTimes steps;
  for (std::size_t i = 0; i < core::kSteps; ++i)
    steps[static_cast<core::Step>(i)] = json.at(3).at(i).get<double>();
  return {count(0), count(1), number(2), steps, number(4), number(5)};
}

Message toJson(const std::vector<core::Span>& spans) {
  Message json = Message::array();
  for (const core::Span& span : spans)
    json.push_back({span.name, span.begin_ns, span.end_ns, span.frame ? Message(*span.frame) : Message()});
  return json;
}

std::vector<core::Span> spansOf(const Message& json) {
  std::vector<core::Span> spans;
  for (const Message& span : json) {
    spans.push_back(
        {span.at(0).get<std::string>(), span.at(1).get<std::int64_t>(), span.at(2).get<std::int64_t>()});
    if (!span.at(3).is_null()) spans.back().frame = span.at(3).get<std::int64_t>();
  }
  return spans;
}

/// Reads a line. Its two sides are one program, so only a line that was lost or cut makes it unreadable.
template <class Reading>
auto readingLine(std::string_view line, Reading reading) try {
  return reading(Message::parse(line));
} catch (const Message::exception&) {
  throw core::graphicsError("a message between the render and a worker process was lost or damaged; run it again");
}

WorkerReport reportOf(const Message& json) {
  if (json.contains("frame"))
    return FrameDone{json.at("frame").get<std::int64_t>(), json.at("reused").get<bool>(),
                     json.at("pixels").get<std::string>()};
  if (json.contains("segment")) return SegmentDone{rangeOf(json.at("segment"))};
  if (json.contains("spans")) return SpansDone{spansOf(json.at("spans"))};
  if (json.contains("finished"))
    return WorkerFinished{statisticsOf(json.at("finished")), textOf(json.at("renderer")),
                          textOf(json.at("driver"))};
  return WorkerFailed{static_cast<core::ErrorKind>(json.at("kind").get<int>()), textOf(json.at("failed")),
                      textOf(json.at("file")), json.at("errno").get<int>()};
}

template <class... Each>
struct Overloaded : Each... {
  using Each::operator()...;
};
template <class... Each>
Overloaded(Each...) -> Overloaded<Each...>;  // clang 14 wants it

}  // namespace

std::string toLine(const request::FrameRange& segment) { return Message{{"segment", toJson(segment)}}.dump(); }

request::FrameRange segmentFromLine(std::string_view line) {
  return readingLine(line, [](const Message& json) { return rangeOf(json.at("segment")); });
}

std::string toLine(const WorkerReport& report) {
  const Message json =
      std::visit(Overloaded{[](const FrameDone& done) {
                              return Message{{"frame", done.k}, {"reused", done.reused}, {"pixels", done.pixels}};
                            },
                            [](const SegmentDone& done) {
                              return Message{{"segment", toJson(done.frames)}};
                            },
                            [](const SpansDone& done) {
                              return Message{{"spans", toJson(done.spans)}};
                            },
                            [](const WorkerFinished& finished) {
                              return Message{{"finished", toJson(finished.spent)},
                                             {"renderer", core::utf8FromBytes(finished.renderer)},
                                             {"driver", core::utf8FromBytes(finished.driver)}};
                            },
                            [](const WorkerFailed& failed) {
                              return Message{{"failed", core::utf8FromBytes(failed.message)},
                                             {"kind", static_cast<int>(failed.kind)},
                                             {"file", core::utf8FromBytes(failed.file.native())},
                                             {"errno", failed.code}};
                            }},
                 report);
  return json.dump();
}

WorkerReport reportFromLine(std::string_view line) { return readingLine(line, reportOf); }

}  // namespace poinsot::job
