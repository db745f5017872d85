// SPDX-License-Identifier: Apache-2.0
#include "describe/alt_text.h"

#include "describe/alt_sections.h"
#include "describe/language.h"
#include "text/math_setter.h"

namespace poinsot::describe {
namespace {

Sentences heading(const scene::Scene& scene) {
  std::string text = text::setTex(scene.show.title).plainText;
  const std::string below = text::setTex(scene.show.subtitle).plainText;
  if (!text.empty() && !below.empty()) text += ": ";
  text += below;
  return text.empty() ? Sentences{} : Sentences{text + "."};
}

}  // namespace

std::string altText(const scene::Scene& scene) {
  const LanguageScope language(scene.output.language);
  std::string paragraph;
  for (const Sentences& part :
       {heading(scene), bodySentences(scene), motionSentences(scene), pictureSentences(scene)})
    for (const std::string& sentence : part) paragraph += (paragraph.empty() ? "" : " ") + sentence;
  return paragraph;
}

}  // namespace poinsot::describe
