// SPDX-License-Identifier: Apache-2.0
#include "job/worker_protocol.h"

#include <nlohmann/json.hpp>

#include "core/json_text.h"

namespace poinsot::job {
namespace {

using Json = nlohmann::json;

std::string textOf(const Json& json) { return core::bytesFromUtf8(json.get<std::string>()); }

Json toJson(const request::FrameRange& frames) { return Json{frames.first, frames.last}; }

request::FrameRange rangeOf(const Json& json) {
  return {json.at(0).get<std::int64_t>(), json.at(1).get<std::int64_t>()};
}

/// The values in force, in the order of the table.
Json toJson(const scene::Allowance& allowance) {
  Json json{{"limits", Json::array()}, {"asset_roots", Json::array()}};
  for (std::size_t i = 0; i < scene::kLimitCount; ++i)
    json["limits"].push_back(allowance.limits[static_cast<scene::Limit>(i)]);
  for (const auto& root : allowance.assetRoots) json["asset_roots"].push_back(core::utf8FromBytes(root.native()));
  return json;
}

scene::Allowance allowanceOf(const Json& json) {
  scene::Allowance allowance;
  for (std::size_t i = 0; i < scene::kLimitCount; ++i)
    if (const auto value = json.at("limits").at(i).get<std::int64_t>(); value > 0)
      allowance.limits.set(static_cast<scene::Limit>(i), value);
  for (const Json& root : json.at("asset_roots")) allowance.assetRoots.emplace_back(textOf(root));
  return allowance;
}

Json toJson(const request::SweepRequest& sweep) {
  Json json{{"map", sweep.map}, {"columns", sweep.columns}, {"labels", Json::array()}};
  for (const std::string& label : sweep.labels) json["labels"].push_back(core::utf8FromBytes(label));
  return json;
}

request::SweepRequest sweepOf(const Json& json) {
  request::SweepRequest sweep{json.at("map").get<bool>(), json.at("columns").get<int>()};
  for (const Json& label : json.at("labels")) sweep.labels.push_back(textOf(label));
  return sweep;
}

Json toJson(const request::SceneRequest& scene) {
  Json json{{"file", core::utf8FromBytes(scene.fileName)},
            {"text", core::utf8FromBytes(scene.text)},
            {"overrides", Json::array()}};
  for (const std::string& override : scene.overrides) json["overrides"].push_back(core::utf8FromBytes(override));
  if (scene.size) json["size"] = {scene.size->width, scene.size->height};
  json["allowance"] = toJson(scene.allowance);
  if (scene.sweep) json["sweep"] = toJson(*scene.sweep);
  if (scene.view) json["view"] = *scene.view;
  return json;
}

request::SceneRequest sceneOf(const Json& json) {
  request::SceneRequest scene{
      textOf(json.at("file")), textOf(json.at("text")), {}, {}, allowanceOf(json.at("allowance"))};
  for (const Json& override : json.at("overrides")) scene.overrides.push_back(textOf(override));
  if (json.contains("size"))
    scene.size = image::PixelSize{json.at("size").at(0).get<int>(), json.at("size").at(1).get<int>()};
  if (json.contains("sweep")) scene.sweep = sweepOf(json.at("sweep"));
  if (json.contains("view")) scene.view = json.at("view").get<std::size_t>();
  return scene;
}

Json toJson(const request::PictureForm& form) {
  Json json{{"transparent", form.transparent}, {"bits", form.bits}};
  if (form.print) json["print"] = {form.print->width_mm, form.print->dpi};
  return json;
}

request::PictureForm formOf(const Json& json) {
  request::PictureForm form{std::nullopt, json.at("transparent").get<bool>(), json.at("bits").get<int>()};
  if (json.contains("print"))
    form.print = request::PrintSize{json.at("print").at(0).get<double>(), json.at("print").at(1).get<double>()};
  return form;
}

// In the order of the fields, so that the two functions below stay readable side by side.
Json toJson(const Statistics& s) {
  Json steps = Json::array();
  for (std::size_t i = 0; i < core::kSteps; ++i) steps.push_back(s.steps[static_cast<core::Step>(i)]);
  return Json{s.frames, s.workers, s.first_s, steps, s.cpu_s, s.peakMemory_bytes};
}

Statistics statisticsOf(const Json& json) {
  const auto count = [&](std::size_t i) { return json.at(i).get<std::int64_t>(); };
  const auto number = [&](std::size_t i) { return json.at(i).get<double>(); };
  core::StepTimes steps;
  for (std::size_t i = 0; i < core::kSteps; ++i)
    steps[static_cast<core::Step>(i)] = json.at(3).at(i).get<double>();
  return {count(0), count(1), number(2), steps, number(4), number(5)};
}

Json toJson(const std::vector<core::Span>& spans) {
  Json json = Json::array();
  for (const core::Span& span : spans)
    json.push_back({span.name, span.begin_ns, span.end_ns, span.frame ? Json(*span.frame) : Json()});
  return json;
}

std::vector<core::Span> spansOf(const Json& json) {
  std::vector<core::Span> spans;
  for (const Json& span : json) {
    spans.push_back(
        {span.at(0).get<std::string>(), span.at(1).get<std::int64_t>(), span.at(2).get<std::int64_t>()});
    if (!span.at(3).is_null()) spans.back().frame = span.at(3).get<std::int64_t>();
  }
  return spans;
}

/// Reads a line. Its two sides are one program, so only a line that was lost or cut makes it unreadable.
template <class Reading>
auto readingLine(std::string_view line, Reading reading) try {
  return reading(Json::parse(line));
} catch (const Json::exception&) {
  throw core::Error(core::ErrorKind::kGraphics,
                    "a message between the render and a worker process was lost or damaged; run it again");
}

WorkerJob jobOf(const Json& json) {
  const Json& target = json.at("target");
  return {sceneOf(json.at("scene")),
          {static_cast<request::OutputKind>(target.at("kind").get<int>()), textOf(target.at("path"))},
          rangeOf(json.at("frames")),
          json.at("time").is_null() ? std::nullopt : std::optional(json.at("time").get<double>()),
          textOf(json.at("work_folder")),
          static_cast<gl::Backend>(json.at("backend").get<int>()),
          json.at("reproducible").get<bool>(),
          json.at("raster_threads").get<int>(),
          formOf(json.at("form")),
          json.at("segment_frames").get<std::int64_t>(),
          json.at("resume").get<bool>(),
          json.at("job").get<std::string>(),
          json.at("trace").get<bool>(),
          json.at("expected_bytes").get<double>(),
          json.at("digests_pixels").get<bool>()};
}

WorkerReport reportOf(const Json& json) {
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

std::string toLine(const WorkerJob& job) {
  return Json{
      {"scene", toJson(job.scene)},
      {"target",
       {{"kind", static_cast<int>(job.target.kind)}, {"path", core::utf8FromBytes(job.target.path.string())}}},
      {"frames", toJson(job.frames)},
      {"time", job.time_s ? Json(*job.time_s) : Json()},
      {"work_folder", core::utf8FromBytes(job.workFolder.string())},
      {"backend", static_cast<int>(job.backend)},
      {"reproducible", job.reproducible},
      {"raster_threads", job.rasterThreads},
      {"segment_frames", job.segmentFrames},
      {"resume", job.resume},
      {"job", job.job},
      {"trace", job.trace},
      {"expected_bytes", job.expected_bytes},
      {"digests_pixels", job.digestsPixels},
      {"form", toJson(job.form)}}
      .dump();
}

std::string toLine(const request::FrameRange& segment) { return Json{{"segment", toJson(segment)}}.dump(); }

WorkerJob jobFromLine(std::string_view line) { return readingLine(line, jobOf); }

request::FrameRange segmentFromLine(std::string_view line) {
  return readingLine(line, [](const Json& json) { return rangeOf(json.at("segment")); });
}

std::string toLine(const WorkerReport& report) {
  const Json json =
      std::visit(Overloaded{[](const FrameDone& done) {
                              return Json{{"frame", done.k}, {"reused", done.reused}, {"pixels", done.pixels}};
                            },
                            [](const SegmentDone& done) {
                              return Json{{"segment", toJson(done.frames)}};
                            },
                            [](const SpansDone& done) {
                              return Json{{"spans", toJson(done.spans)}};
                            },
                            [](const WorkerFinished& finished) {
                              return Json{{"finished", toJson(finished.spent)},
                                          {"renderer", core::utf8FromBytes(finished.renderer)},
                                          {"driver", core::utf8FromBytes(finished.driver)}};
                            },
                            [](const WorkerFailed& failed) {
                              return Json{{"failed", core::utf8FromBytes(failed.message)},
                                          {"kind", static_cast<int>(failed.kind)},
                                          {"file", core::utf8FromBytes(failed.file.native())},
                                          {"errno", failed.code}};
                            }},
                 report);
  return json.dump();
}

WorkerReport reportFromLine(std::string_view line) { return readingLine(line, reportOf); }

}  // namespace poinsot::job
