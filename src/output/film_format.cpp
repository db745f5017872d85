// SPDX-License-Identifier: Apache-2.0
#include "output/film_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/text.h"
#include "output/ffmpeg_encoder.h"
#include "output/palette.h"

namespace poinsot::output {
namespace {

struct CodecFacts {
  FilmCodec codec;
  std::string_view name;
  bool transparent;
  bool fine;  ///< whether 4:4:4 can be chosen
  bool lossless;
};

constexpr std::array<CodecFacts, 7> kCodecs{{{FilmCodec::kH264, "h264", false, true, true},
                                             {FilmCodec::kHevc, "hevc", false, true, true},
                                             {FilmCodec::kProRes, "prores", true, true, false},
                                             {FilmCodec::kVp9, "vp9", true, true, true},
                                             {FilmCodec::kAv1, "av1", false, false, false},
                                             {FilmCodec::kGif, "gif", false, true, false},
                                             {FilmCodec::kApng, "apng", true, true, true}}};

const CodecFacts& codecFactsOf(FilmCodec codec) { return kCodecs[static_cast<std::size_t>(codec)]; }

struct ContainerFacts {
  std::string_view name;
  std::vector<FilmCodec> codecs;
};

const ContainerFacts& containerFactsOf(FilmContainer container) {
  static const std::array<ContainerFacts, 5> facts{{{"mp4", {FilmCodec::kH264, FilmCodec::kHevc}},
                                                    {"mov", {FilmCodec::kProRes}},
                                                    {"webm", {FilmCodec::kVp9, FilmCodec::kAv1}},
                                                    {"gif", {FilmCodec::kGif}},
                                                    {"apng", {FilmCodec::kApng}}}};
  return facts[static_cast<std::size_t>(container)];
}

constexpr std::array kContainers{FilmContainer::kMp4, FilmContainer::kMov, FilmContainer::kWebm,
                                 FilmContainer::kGif, FilmContainer::kApng};

std::string namesOf(std::span<const FilmCodec> codecs) {
  std::vector<std::string_view> names;
  for (const FilmCodec codec : codecs) names.push_back(nameOf(codec));
  return core::joined(names, ", ");
}

template <class Condition>
std::string codecsWith(Condition condition) {
  std::vector<FilmCodec> codecs;
  for (const CodecFacts& facts : kCodecs)
    if (condition(facts)) codecs.push_back(facts.codec);
  return namesOf(codecs);
}

void checkSize(const FilmFormat& format, image::PixelSize size) {
  const bool halved = format.chroma == Chroma::k420 && !isMadeWhole(format.container);
  const int step = halved ? 2 : 1;
  if (size.width >= step && size.height >= step && size.width % step == 0 && size.height % step == 0) return;
  throw core::usageError(
      fmt::format("a film of {}x{} pixels: width and height must be even (chroma has half of each); the "
                  "nearest is {}x{}",
                  size.width, size.height, std::max(2, size.width & ~1), std::max(2, size.height & ~1)));
}

void checkQuality(const FilmFormat& format) {
  if (!(format.crf >= 0 && format.crf <= 51))
    throw core::usageError(fmt::format("crf {}: must be from 0 (lossless) to 51", format.crf));
  if (format.crf == 0 && !codecFactsOf(format.codec).lossless)
    throw core::usageError(fmt::format("crf 0: {} is never lossless; {} can be", nameOf(format.codec),
                                       codecsWith([](const CodecFacts& facts) { return facts.lossless; })));
}

/// Limits the frame rate of a GIF. A GIF stores times in hundredths of a second, and browsers show a picture of
/// less than two hundredths for ten hundredths.
void checkRate(const FilmFormat& format, const core::Rational& fps) {
  if (format.container == FilmContainer::kGif && fps.value() > 50)
    throw core::usageError(fmt::format("a .gif of {:g} frames/s: its players show at most 50", fps.value()));
}

void checkCodec(const FilmFormat& format) {
  const auto codecs = codecsOf(format.container);
  const CodecFacts& codec = codecFactsOf(format.codec);
  if (std::ranges::find(codecs, format.codec) == codecs.end())
    throw core::usageError(fmt::format("codec {}: not possible in a .{}, which can contain: {}", codec.name,
                                       nameOf(format.container), namesOf(codecs)));
  if (format.transparent && !codec.transparent)
    throw core::usageError(
        fmt::format("{} in a .{} has no half-transparent pixels; use vp9 in a .webm, prores in a .mov, .apng or "
                    "numbered pictures",
                    codec.name, nameOf(format.container)));
  if (format.chroma == Chroma::k444 && !codec.fine)
    throw core::usageError(fmt::format("chroma 4:4:4: not possible with {}, only with {}", codec.name,
                                       codecsWith([](const CodecFacts& facts) { return facts.fine; })));
  if (format.chroma == Chroma::k444 && format.codec == FilmCodec::kVp9 && format.transparent)
    throw core::usageError("chroma 4:4:4: not possible with vp9 and transparency; prores in a .mov has both");
}

void checkEncoder(const FilmFormat& format) {
  if (format.codec == FilmCodec::kGif) checkPaletteMaker();
  const char* missing = missingEncoder(format.codec);
  if (missing == nullptr) return;
  std::vector<FilmCodec> there;
  for (const CodecFacts& facts : kCodecs)
    if (missingEncoder(facts.codec) == nullptr) there.push_back(facts.codec);
  const std::string choice =
      there.empty() ? "" : fmt::format("choose another output.codec ({}) or ", namesOf(there));
  throw core::encodeError(
      fmt::format("the FFmpeg of this machine has no encoder {}, which a film in {} needs; {}install an FFmpeg "
                  "that has it, such as Debian's",
                  missing, nameOf(format.codec), choice));
}

}  // namespace

std::optional<FilmContainer> filmContainer(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  for (const FilmContainer container : kContainers)
    if (extension == fmt::format(".{}", nameOf(container))) return container;
  return std::nullopt;
}

std::span<const FilmContainer> filmContainers() { return kContainers; }

std::string_view nameOf(FilmContainer container) { return containerFactsOf(container).name; }

std::span<const FilmCodec> codecsOf(FilmContainer container) { return containerFactsOf(container).codecs; }

std::string_view nameOf(FilmCodec codec) { return codecFactsOf(codec).name; }

std::optional<FilmCodec> filmCodec(std::string_view name) {
  for (const CodecFacts& facts : kCodecs)
    if (facts.name == name) return facts.codec;
  return std::nullopt;
}

bool isMadeWhole(FilmContainer container) {
  return container == FilmContainer::kGif || container == FilmContainer::kApng;
}

std::string filmFormatsText() {
  std::vector<std::string> texts;
  for (const FilmContainer container : kContainers) texts.push_back(fmt::format("NAME.{}", nameOf(container)));
  return core::joined(texts, ", ");
}

void checkFormat(const FilmFormat& format, image::PixelSize size, const core::Rational& fps) {
  checkCodec(format);
  checkQuality(format);
  checkSize(format, size);
  checkRate(format, fps);
  checkEncoder(format);
}

}  // namespace poinsot::output
