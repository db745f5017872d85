// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "text/glyph_run.h"

// NOLINTBEGIN(bugprone-reserved-identifier): cairo's own names.
struct _cairo;
struct _cairo_font_face;
// NOLINTEND(bugprone-reserved-identifier)

namespace poinsot::output {

/// The embedded mathematics font as cairo has it, of the thread that asks.
std::shared_ptr<_cairo_font_face> cairoFont();

/// Sets font and size on a cairo context: unhinted, unrounded.
void useFont(_cairo* context, _cairo_font_face* font, double size);

/// A glyph's outline as SVG path data, 1000 units to the em, y down; empty for a space.
std::string svgPathOf(text::GlyphId id);

}  // namespace poinsot::output
