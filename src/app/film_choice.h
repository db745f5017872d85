// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/output_target.h"
#include "app/picture_form.h"
#include "output/film_format.h"
#include "scene/scene.h"

namespace poinsot::app {

/// How a film of that name is made: what the scene asks for, and else what its kind of file usually holds.
output::FilmFormat filmFormat(const OutputTarget& target, const scene::Output& asked, const PictureForm& form);

}  // namespace poinsot::app
