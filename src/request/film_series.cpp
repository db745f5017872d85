// SPDX-License-Identifier: Apache-2.0
#include "request/film_series.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/text.h"
#include "request/sweep_cells.h"
#include "scene/sweep.h"

namespace poinsot::request {
namespace {

constexpr const char* kValue = "{value}";

struct Range {
  std::size_t override = 0;  ///< index of the override that has the range
  scene::SweepAxis axis;
};

std::vector<Range> rangesIn(const std::vector<std::string>& overrides) {
  std::vector<Range> ranges;
  std::size_t films = 1;
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    auto axis = scene::sweepAxis(overrides[i], kMostFilms);
    if (!axis) continue;
    expectOnce(overrides, axis->key);
    films *= axis->values.size();
    if (films > kMostFilms)
      throw core::usageError(
          fmt::format("--series: {} films or more; a series has at most {}", films, kMostFilms));
    ranges.push_back({i, std::move(*axis)});
  }
  if (ranges.empty()) throw core::usageError("--series: needs a range, such as -D 'motion.spin=1..5 rev/s:9'");
  return ranges;
}

/// Returns the name's text that stands for the value of each range.
std::vector<std::string> placesOf(const std::vector<Range>& ranges, const std::string& name) {
  std::vector<std::string> places;
  const bool one = ranges.size() == 1 && name.find(kValue) != std::string::npos;
  for (const Range& range : ranges) {
    places.push_back(one ? kValue : "{" + range.axis.key + "}");
    if (name.find(places.back()) == std::string::npos)
      throw core::usageError(fmt::format(
          "-o {}: all films would have the same name for each {}; write {} in the name", core::printable(name),
          core::printable(range.axis.key), ranges.size() == 1 ? kValue : places.back()));
  }
  return places;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

void expectDifferentNames(const std::vector<SeriesFilm>& films) {
  std::vector<std::string> names;
  for (const SeriesFilm& film : films) names.push_back(film.output);
  std::ranges::sort(names);
  if (const auto same = std::ranges::adjacent_find(names); same != names.end())
    throw core::usageError(
        fmt::format("{}: two films of the series would have this name, because their values are "
                    "rounded to the same number; give fewer values",
                    core::printable(*same)));
}

}  // namespace

bool isSeriesName(const std::string& name) { return name.find(kValue) != std::string::npos; }

std::vector<SeriesFilm> seriesOf(const std::vector<std::string>& overrides, const std::string& name) {
  const std::vector<Range> ranges = rangesIn(overrides);
  const std::vector<std::string> places = placesOf(ranges, name);
  std::vector<SeriesFilm> films{{overrides, name}};
  for (std::size_t r = ranges.size(); r-- > 0;) {  // the last range first, so that the first varies fastest
    std::vector<SeriesFilm> finer;
    for (const SeriesFilm& film : films)
      for (std::size_t i = 0; i < ranges[r].axis.values.size(); ++i) {
        SeriesFilm one = film;
        one.overrides[ranges[r].override] = ranges[r].axis.override(i);
        replaceAll(one.output, places[r], ranges[r].axis.values[i].number);
        finer.push_back(std::move(one));
      }
    films = std::move(finer);
  }
  expectDifferentNames(films);
  return films;
}

}  // namespace poinsot::request
