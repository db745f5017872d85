// SPDX-License-Identifier: Apache-2.0
#include "cli/still_options.h"

#include <fmt/format.h>

#include "cli/command.h"
#include "cli/option_values.h"
#include "core/error.h"
#include "core/text.h"
#include "figure/figure.h"
#include "request/sweep_cells.h"

namespace poinsot::cli {
namespace {

/// Sets the size on paper. A figure always has a size on paper, and a picture only if the options give one.
request::PictureOptions printed(request::PictureOptions form, const StillOptions& options,
                                request::OutputKind kind) {
  if (kind == request::OutputKind::kFigure || !options.width.empty()) form.print.emplace();
  if (!options.width.empty()) form.print->width_mm = parseWidth_mm(options.width);
  if (options.dpi && !form.print) throw core::usageError("--dpi needs --width, the width on paper");
  if (options.dpi) form.print->dpi = *options.dpi;
  if (!options.type.empty() && !form.print) throw core::usageError("--type needs --width, the width on paper");
  if (!options.type.empty()) form.print->type_pt = parseTypeSize_pt(options.type);
  form.svgText = options.svgText;
  return form;
}

/// Sets the size in pixels of a picture on paper. The size in the scene gives only the aspect ratio. With --type,
/// the size of text in the scene has no effect.
void setSizes(const request::PictureOptions& form, request::RequestedScene& requested) {
  if (!form.print) return;
  if (form.print->type_pt) requested.setTextSize(1);
  requested.resize(printedPixels(*form.print, requested.size(), requested.request.allowance.limits));
}

std::optional<double> askedTime_s(const StillOptions& options) {
  return options.time ? std::optional(parseTime_s("--time", *options.time)) : std::nullopt;
}

}  // namespace

void addStillOptions(const Command& command, StillOptions& options) {
  command
      .option("-t,--time", options.time,
              "film time, such as 1.25 (seconds) or '90 ms' (default: the scene's time.still)")
      .type("T");
  command
      .option("--width", options.width,
              "width on paper in mm, cm, in or pt; text and lines then have sizes in points, and --size gives "
              "only the aspect ratio (default for PDF, SVG and TeX: 86mm)")
      .type("LENGTH")
      .notEmpty();
  command.flag("--svg-text", options.svgText,
               "write the labels of an SVG as text in Latin Modern and not as outlines, to edit them in a drawing "
               "program");
  command.option("--dpi", options.dpi, "pixels per inch on paper (default: 600)").type("N").range(1.0, 10000.0);
  command
      .option(
          "--type", options.type,
          "one size for all small text on paper, such as 8pt, in views and plots of any size; titles are 8/7 and "
          "the names of L and omega 10/7 as large (default: text is smaller in small views and plots)")
      .type("LENGTH")
      .notEmpty();
}

int makeStill(const RenderOptions& options, const StillOptions& still, request::PictureOptions form,
              const StillTarget& targetOf) {
  const auto named = targetOf("SCENE");  // checked now, to report a wrong name before the scene is read
  checkBits(form.bits, named);
  if (still.svgText && figure::figureMedium(named.path) != figure::FigureMedium::kSvg)
    throw core::usageError(fmt::format("--svg-text: possible only for a figure NAME.svg, got {}",
                                       core::printable(named.path.string())));
  form = printed(form, still, named.kind);
  if (form.print && !options.quality.empty())
    throw core::usageError("-q: not possible for a picture on paper; set its pixels with --width and --dpi");
  const auto asked_s = askedTime_s(still);
  request::RequestedScene requested = requestedScene(options);
  const scene::Scene& scene = requested.scene;
  if (asked_s && !(*asked_s >= 0 && *asked_s <= scene.time.duration_s))
    throw core::usageError(fmt::format("--time {}: the film lasts from 0 to {} s", core::printable(*still.time),
                                       scene.time.duration_s));
  if (asked_s && requested.request.sweep && request::SweepGrid(requested.request).variesInstant())
    throw core::usageError(fmt::format(
        "--time: the range of {} gives each cell its own time; leave out one of them", scene::kInstantKey));
  setSizes(form, requested);
  const double time_s = asked_s.value_or(scene.time.stillTime_s());
  const request::OutputTarget target = targetOf(scene.name);
  return renderTo(options, {std::move(requested), target, {0, 0}}, {.time_s = time_s, .form = form});
}

}  // namespace poinsot::cli
