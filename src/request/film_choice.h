// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/film_format.h"
#include "request/output_target.h"
#include "request/picture_form.h"
#include "scene/scene.h"

namespace poinsot::request {

/// How a film of that name is made: what the scene asks for, and else what its kind of file usually holds.
output::FilmFormat filmFormat(const OutputTarget& target, const scene::Output& asked, const PictureForm& form);

}  // namespace poinsot::request
