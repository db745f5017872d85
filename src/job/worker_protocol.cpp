// SPDX-License-Identifier: Apache-2.0
#include "job/worker_protocol.h"

#include <nlohmann/json.hpp>

#include "core/json.h"

namespace poinsot::job {
namespace {

using WireJson = nlohmann::json;

std::string textOf(const WireJson& json) { return core::bytesFromUtf8(json.get<std::string>()); }

WireJson toJson(const request::FrameRange& frames) { return WireJson{frames.first, frames.last}; }

request::FrameRange rangeOf(const WireJson& json) {
  return {json.at(0).get<std::int64_t>(), json.at(1).get<std::int64_t>()};
}

// Lists the fields in the same order as statisticsOf() reads them.
WireJson toJson(const Statistics& s) {
  WireJson steps = WireJson::array();
  for (std::size_t i = 0; i < core::kSteps; ++i) steps.push_back(s.steps[static_cast<core::Step>(i)]);
  return WireJson{s.frames, s.workers, s.first_s, steps, s.cpu_s, s.peakMemory_bytes};
}

Statistics statisticsOf(const WireJson& json) {
  const auto count = [&](std::size_t i) { return json.at(i).get<std::int64_t>(); };
  const auto number = [&](std::size_t i) { return json.at(i).get<double>(); };
  core::StepTimes steps;
  for (std::size_t i = 0; i < core::kSteps; ++i)
    steps[static_cast<core::Step>(i)] = json.at(3).at(i).get<double>();
  return {count(0), count(1), number(2), steps, number(4), number(5)};
}

WireJson toJson(const std::vector<core::Span>& spans) {
  WireJson json = WireJson::array();
  for (const core::Span& span : spans)
    json.push_back({span.name, span.begin_ns, span.end_ns, span.frame ? WireJson(*span.frame) : WireJson()});
  return json;
}

std::vector<core::Span> spansOf(const WireJson& json) {
  std::vector<core::Span> spans;
  for (const WireJson& span : json) {
    spans.push_back(
        {span.at(0).get<std::string>(), span.at(1).get<std::int64_t>(), span.at(2).get<std::int64_t>()});
    if (!span.at(3).is_null()) spans.back().frame = span.at(3).get<std::int64_t>();
  }
  return spans;
}

/// Parses a line and passes the JSON to `reading`. Fails only for truncated lines, because both ends are one
/// program.
template <class Reading>
auto readingLine(std::string_view line, Reading reading) try {
  return reading(WireJson::parse(line));
} catch (const WireJson::exception&) {
  throw core::graphicsError(
      "a message between the render and a worker process was lost or damaged; run the command again");
}

WorkerReport reportOf(const WireJson& json) {
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
Overloaded(Each...) -> Overloaded<Each...>;  // deduction guide, which clang 14 needs

}  // namespace

std::string toLine(const request::FrameRange& segment) { return WireJson{{"segment", toJson(segment)}}.dump(); }

request::FrameRange segmentFromLine(std::string_view line) {
  return readingLine(line, [](const WireJson& json) { return rangeOf(json.at("segment")); });
}

std::string toLine(const WorkerReport& report) {
  const WireJson json =
      std::visit(Overloaded{[](const FrameDone& done) {
                              return WireJson{{"frame", done.k}, {"reused", done.reused}, {"pixels", done.pixels}};
                            },
                            [](const SegmentDone& done) {
                              return WireJson{{"segment", toJson(done.frames)}};
                            },
                            [](const SpansDone& done) {
                              return WireJson{{"spans", toJson(done.spans)}};
                            },
                            [](const WorkerFinished& finished) {
                              return WireJson{{"finished", toJson(finished.spent)},
                                              {"renderer", core::utf8FromBytes(finished.renderer)},
                                              {"driver", core::utf8FromBytes(finished.driver)}};
                            },
                            [](const WorkerFailed& failed) {
                              return WireJson{{"failed", core::utf8FromBytes(failed.message)},
                                              {"kind", static_cast<int>(failed.kind)},
                                              {"file", core::utf8FromBytes(failed.file.native())},
                                              {"errno", failed.code}};
                            }},
                 report);
  return json.dump();
}

WorkerReport reportFromLine(std::string_view line) { return readingLine(line, reportOf); }

}  // namespace poinsot::job
