// SPDX-License-Identifier: Apache-2.0
#include "app/picture_words.h"

#include "app/alt_text.h"
#include "core/text.h"
#include "text/math_setter.h"

namespace poinsot::app {

PictureWords pictureWords(const scene::Scene& scene) {
  const std::string& title = scene.show.title;
  return {title.empty() ? core::printable(scene.name) : text::setTex(title).plainText, altText(scene)};
}

}  // namespace poinsot::app
