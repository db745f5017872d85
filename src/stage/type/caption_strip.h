// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "draw/picture.h"
#include "scene/scene.h"
#include "stage/moment.h"
#include "stage/palette.h"
#include "stage/type/lettering.h"

namespace poinsot::stage {

/// Captions of a film, centred in a strip at the bottom of the picture. The strip is reserved for the complete
/// film, so that nothing moves when captions come and go. A caption that is too long for one line takes two lines.
class CaptionStrip {
 public:
  explicit CaptionStrip(const scene::Scene& scene);

  /// Returns the height of the strip; 0 if no captions are drawn.
  double height_px(glm::vec2 size_px, const Sizing& sizing) const;
  void add(draw::Picture& picture, const Moment& moment, const Sizing& sizing, const Palette& colors) const;

 private:
  struct Line {
    std::string tex;
    double width_em = 0, top_em = 0, bottom_em = 0;  // width; height of the ink above and below the baseline
  };
  struct Entry {
    scene::Caption caption;
    Line whole;
    std::optional<std::array<Line, 2>> halves;
  };

  static Line lineOf(const std::string& tex);
  static std::optional<std::array<Line, 2>> halvesOf(const std::string& tex);
  static std::vector<Line> linesOf(const Entry& entry, double room_em);
  static double height_em(const std::vector<Line>& lines);
  double opacity(const scene::Caption& caption, const Moment& moment) const;

  bool isDrawn(const Sizing& sizing) const { return shown_.value_or(!sizing.isPrint); }

  std::vector<Entry> entries_;
  double duration_s_;          // a caption that lasts to the end does not fade out
  std::optional<bool> shown_;  // nullopt: not in figures for print
};

}  // namespace poinsot::stage
