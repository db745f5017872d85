// SPDX-License-Identifier: Apache-2.0
// Films of a series: their values, their names, and requests that would lose a film.
#include "request/film_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::request {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Words = std::vector<std::string>;

Words outputs(const std::vector<SeriesFilm>& films) {
  Words names;
  for (const SeriesFilm& film : films) names.push_back(film.output);
  return names;
}

std::string refusal(const Words& overrides, const std::string& name) {
  try {
    seriesOf(overrides, name);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    return error.what();
  }
  return "none";
}

TEST(FilmSeries, HasOneFilmForEachValue) {
  const auto films = seriesOf({"show.title='Spin'", "motion.spin=1..3 rev/s:5"}, "films/{value}.mp4");
  EXPECT_THAT(outputs(films),
              ElementsAre("films/1.0.mp4", "films/1.5.mp4", "films/2.0.mp4", "films/2.5.mp4", "films/3.0.mp4"));
  EXPECT_THAT(films[1].overrides, ElementsAre("show.title='Spin'", "motion.spin=1.5 rev/s"));
}

TEST(FilmSeries, CombinesSeveralRangesAndVariesTheFirstFastest) {
  const auto films = seriesOf({"time.speed=1|2", "motion.omega_body=[0.1..0.3:3, 4, 0]", "time.start=0|1"},
                              "{time.start}/{motion.omega_body}_{time.speed}_{frame:04}.png");
  ASSERT_EQ(films.size(), 12u);
  EXPECT_EQ(films[0].output, "0/0.1_1_{frame:04}.png");
  EXPECT_EQ(films[1].output, "0/0.1_2_{frame:04}.png");
  EXPECT_EQ(films[2].output, "0/0.2_1_{frame:04}.png");
  EXPECT_EQ(films[11].output, "1/0.3_2_{frame:04}.png");
  EXPECT_THAT(films[11].overrides, ElementsAre("time.speed=2", "motion.omega_body=[0.3, 4, 0]", "time.start=1"));
}

// A grid has 100 cells at most, because they share one picture.
TEST(FilmSeries, HasMoreFilmsThanAGridHasCells) {
  EXPECT_EQ(seriesOf({"time.start=1..5000:5000"}, "{value}.mp4").size(), 5000u);
  EXPECT_THAT(refusal({"time.start=1..5000:5000", "time.speed=1|2|3"}, "{time.start}_{time.speed}.mp4"),
              HasSubstr("--series: 15000 films or more; a series has at most 10000"));
  EXPECT_THAT(refusal({"time.start=1..20000:20000"}, "{value}.mp4"), HasSubstr("from 2 to 10000 values"));
}

TEST(FilmSeries, RejectsARequestThatWouldLoseAFilm) {
  EXPECT_THAT(refusal({"time.speed=2"}, "{value}.mp4"), HasSubstr("--series: needs a range"));
  EXPECT_THAT(refusal({"time.speed=1|2"}, "a.mp4"), HasSubstr("write {value} in the name"));
  EXPECT_THAT(refusal({"time.speed=1|2", "time.start=1|2"}, "{value}.mp4"),
              HasSubstr("for each time.speed; write {time.speed} in the name"));
  EXPECT_THAT(refusal({"time.speed=1|2", "time.start=1|2"}, "{time.speed}.mp4"),
              HasSubstr("for each time.start; write {time.start} in the name"));
  EXPECT_THAT(refusal({"time.speed=1|2", "time.speed=1|2"}, "{value}.mp4"), HasSubstr("given more than once"));
  EXPECT_THAT(refusal({"time.speed=1..1.01:9:log"}, "{value}.mp4"), HasSubstr("1.01.mp4: two films"));
}

}  // namespace
}  // namespace poinsot::request
