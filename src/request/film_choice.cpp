// SPDX-License-Identifier: Apache-2.0
#include "request/film_choice.h"

#include "core/expect.h"

namespace poinsot::request {
namespace {

output::Effort effortOf(const std::string& word) {
  if (word == "fast") return output::Effort::kFast;
  return word == "slow" ? output::Effort::kSlow : output::Effort::kMedium;
}

}  // namespace

output::FilmFormat filmFormat(const OutputTarget& target, const scene::Output& asked, const PictureForm& form) {
  const auto container = output::filmContainer(target.path);
  POINSOT_EXPECT(container);
  output::FilmFormat format;
  format.container = *container;
  format.codec = output::filmCodec(asked.codec).value_or(output::codecsOf(*container).front());
  format.chroma = asked.chroma == "4:4:4" ? output::Chroma::k444 : output::Chroma::k420;
  format.effort = effortOf(asked.effort);
  format.transparent = form.transparent;
  format.crf = asked.crf;
  return format;
}

}  // namespace poinsot::request
