// SPDX-License-Identifier: Apache-2.0
#include "job/job_identity.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>

#include "core/version.h"
#include "describe/picture_words.h"
#include "image/png_file.h"
#include "output/library_versions.h"
#include "request/output_target.h"

namespace poinsot::job {
namespace {

/// Adds a text to the hash, preceded by its length. The length keeps "ab", "c" apart from "a", "bc".
void addText(core::Sha256& sum, std::string_view text) {
  sum.add(fmt::format("{}:", text.size()));
  sum.add(text);
}

void addDigest(core::Sha256& sum, const core::Digest& digest) { sum.add(std::as_bytes(std::span(digest))); }

void addSweep(core::Sha256& sum, const request::SweepRequest& sweep) {
  addText(sum, sweep.map ? "map" : "sweep");
  addText(sum, fmt::format("{}", sweep.columns));
  for (const std::string& label : sweep.labels) addText(sum, label);
}

}  // namespace

core::Digest sceneDigest(const request::RequestedScene& requested) {
  const request::SceneRequest& request = requested.request;
  core::Sha256 sum;
  addText(sum, request.text);
  addText(sum, fmt::format("{}", request.overrides.size()));
  for (const std::string& override : request.overrides) addText(sum, override);
  for (const scene::InputFile& input : requested.scene.inputs) {
    addText(sum, input.path);
    addDigest(sum, input.digest);
  }
  if (request.sweep) addSweep(sum, *request.sweep);
  if (request.view) addText(sum, fmt::format("view {}", *request.view));
  return sum.finish();
}

std::string renderSettings(const RenderRequest& render) {
  const scene::Scene& scene = render.scene.scene;
  const request::PictureOptions& form = render.form;
  nlohmann::ordered_json settings{{"poinsot", core::version()},
                                  {"size", {scene.output.width, scene.output.height}},
                                  {"reproducible", render.reproducible}};
  if (form.transparent) settings["transparent"] = true;
  if (form.crop) settings["crop"] = true;
  if (form.svgText) settings["svg_text"] = true;
  if (form.bits != 8) settings["bits"] = form.bits;
  if (form.print) settings["print"] = {form.print->width_mm, form.print->dpi};
  if (form.print && form.print->type_pt) settings["type"] = *form.print->type_pt;
  if (render.target.kind != request::OutputKind::kFilm) {
    settings["libpng"] = image::libpngVersion();
    return settings.dump();
  }
  settings["fps"] = core::toString(scene.time.fps);
  const output::FilmFormat film = request::filmFormat(render.target, scene.output, form);
  settings["container"] = output::nameOf(film.container);
  settings["codec"] = output::nameOf(film.codec);
  settings["chroma"] = scene.output.chroma;
  settings["effort"] = scene.output.effort;
  settings["crf"] = film.crf;
  if (film.container == output::FilmContainer::kGif && scene.output.colors != output::kMostColors)
    settings["colors"] = scene.output.colors;
  settings["segment"] = render.segmentFrames;  // segments change the film, because each begins with a key frame
  for (const output::LibraryVersion& library : output::libraryVersions()) settings[library.name] = library.version;
  return settings.dump();
}

core::Digest jobDigest(const core::Digest& scene, const std::string& settings) {
  core::Sha256 sum;
  addDigest(sum, scene);
  addText(sum, settings);
  return sum.finish();
}

JobRecord jobRecordOf(const RenderRequest& render) {
  const scene::Scene& scene = render.scene.scene;
  const core::Digest sceneSum = sceneDigest(render.scene);
  const describe::PictureWords words = describe::pictureWords(render.scene);
  JobRecord job;
  job.scene = core::toHex(sceneSum);
  job.settings = renderSettings(render);
  job.digest = core::toHex(jobDigest(sceneSum, job.settings));
  job.kind = render.target.kind;
  job.frames = render.frames;
  job.segmentFrames = render.segmentFrames;
  job.shards = render.shard ? render.shard->n : 1;
  job.inputs = scene.inputs;
  job.title = words.title;
  job.description = words.description;
  if (job.kind != request::OutputKind::kFilm) return job;
  job.film = {*output::filmContainer(render.target.path), scene.time.fps, scene.output.colors};
  job.subtitles = request::subtitlesOf(scene, render.frames);
  return job;
}

FrameDigester::FrameDigester(const std::string& settings, const std::string& renderer) {
  core::Sha256 sum;
  addText(sum, settings);
  addText(sum, renderer);
  basis_ = sum.finish();
}

core::Digest FrameDigester::operator()(const draw::Picture& picture) {
  core::Sha256 sum;
  addDigest(sum, basis_);
  addDigest(sum, pictureDigest_(picture));
  return sum.finish();
}

}  // namespace poinsot::job
