// SPDX-License-Identifier: Apache-2.0
#include "describe/report_scene.h"

#include "describe/report_sections.h"
#include "stage/picture_motion.h"

namespace poinsot::describe {

Report sceneReport(const scene::Scene& scene) {
  const double start_s = scene.time.start_s;
  const ReportSpan span{start_s, stage::filmClock(scene).motionTime_s(scene.time.duration_s)};
  return {scene.name,
          {bodySection(scene), startSection(scene), flightSection(scene), constructionSection(scene),
           symmetricSection(scene), heavyTopSection(scene), lossSection(scene), stabilitySection(scene),
           loopSection(scene), accuracySection(scene, span)}};
}

}  // namespace poinsot::describe
