// SPDX-License-Identifier: Apache-2.0
#include "job/render_request.h"

#include <utility>

#include "job/job_identity.h"
#include "request/memory.h"

namespace poinsot::job {

RenderRequest renderRequest(request::RequestedScene scene, const request::OutputTarget& target,
                            const request::FrameRange& frames, const RenderChoices& choices) {
  RenderRequest request{choices, std::move(scene), target, frames};
  request.reproducible |= request.shard.has_value();
  request.worker_bytes = request::workerMemory_bytes(target, request.scene, request.form);
  using enum request::OutputKind;
  if (request.shard || target.kind == kFilm || target.kind == kSequence) request.record = jobRecordOf(request);
  return request;
}

void expectWithinMemory(const RenderRequest& request) {
  request::expectWithinMemory(request.worker_bytes, request::pictureText(request.scene.size()),
                              request.scene.request.allowance.limits);
}

}  // namespace poinsot::job
