// SPDX-License-Identifier: Apache-2.0
#include "cli/shard_run.h"

#include <fmt/format.h>

#include "app/work_folder.h"
#include "app/work_left.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/text.h"
#include "gl/shader_cache.h"

namespace poinsot::cli {

int listShardsLeft(const app::RenderRequest& request) {
  const auto folder = app::workFolderOf(request.target.path);
  const app::WorkLeft left = app::workLeft(*request.job, app::statusOf(folder, *request.job, request.target),
                                           request.shard->n, request.target);
  if (left.none())
    writeErr(fmt::format("poinsot: {} is complete\n", core::printable(request.target.path.string())));
  else
    writeOut(app::shardsText(left.shards) + "\n");
  return left.none() ? kDone : kNo;
}

bool isShardOfFinishedFilm(const app::RenderRequest& request) {
  return request.shard && app::isFinished(*request.job, request.target.path);
}

std::string shaderCacheNote(const app::RenderRequest& request) {
  if (!request.shard || gl::isShaderCacheOff() || !gl::shaderCacheFolder(request.reproducible).empty()) return "";
  return "poinsot: note: each shard compiles its shaders anew, which takes up to 3 s, because there is no folder "
         "to keep them in; set HOME or POINSOT_CACHE to a folder of yours\n";
}

}  // namespace poinsot::cli
