// SPDX-License-Identifier: Apache-2.0
#include "cli/shard_run.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/text.h"
#include "gl/shader_cache.h"
#include "job/work_folder.h"
#include "job/work_left.h"

namespace poinsot::cli {

int listShardsLeft(const job::RenderRequest& request) {
  const auto folder = job::workFolderOf(request.target.path);
  const job::WorkLeft left = job::workLeft(*request.record, job::statusOf(folder, *request.record, request.target),
                                           request.shard->n, request.target);
  if (left.none())
    writeErr(fmt::format("poinsot: {} is complete\n", core::printable(request.target.path.string())));
  else
    writeOut(job::shardsText(left.shards) + "\n");
  return left.none() ? kDone : kNo;
}

bool isShardOfFinishedFilm(const job::RenderRequest& request) {
  return request.shard && job::isFinished(*request.record, request.target.path);
}

std::string shaderCacheNote(const job::RenderRequest& request) {
  if (!request.shard || gl::isShaderCacheOff() || !gl::shaderCacheFolder(request.reproducible).empty()) return "";
  return "poinsot: note: each shard compiles its shaders anew, which takes up to 3 s, because there is no folder "
         "to keep them in; set HOME or POINSOT_CACHE to a folder of yours\n";
}

}  // namespace poinsot::cli
