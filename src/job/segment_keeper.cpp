// SPDX-License-Identifier: Apache-2.0
#include "job/segment_keeper.h"

#include "job/job_record.h"

namespace poinsot::job {
namespace {

bool samePictures(const SegmentRecord& record, FrameSource& source) {
  for (std::int64_t k = record.frames.first; k <= record.frames.last; ++k)
    if (record.digests[static_cast<std::size_t>(k - record.frames.first)] != core::toHex(source.digest(k)))
      return false;
  return true;
}

}  // namespace

SegmentKeeper::SegmentKeeper(const WorkerTask& task, std::string renderer)
    : target_(task.render.target),
      workFolder_(task.workFolder),
      records_(task.workFolder, task.render.target),
      resume_(task.resumes()),
      jobDigest_(task.render.record ? task.render.record->digest : ""),
      renderer_(std::move(renderer)) {}

bool SegmentKeeper::has(const request::FrameRange& segment, FrameSource& source) const {
  auto record = resume_ ? records_.find(segment) : std::nullopt;
  if (!record || !SegmentRecords::isWhole(*record)) return false;
  if (record->jobDigest == jobDigest_ && record->renderer == renderer_) return true;
  if (!samePictures(*record, source)) return false;
  record->jobDigest = jobDigest_;
  record->renderer = renderer_;
  records_.keep(*record);
  return true;
}

void SegmentKeeper::keep(const request::FrameRange& segment, std::vector<std::string> digests) const {
  SegmentRecord record{segment, jobDigest_, renderer_, std::move(digests), {}};
  for (const auto& file : segmentFiles(workFolder_, target_, segment)) record.files.push_back(recordOf(file));
  records_.keep(record);
}

}  // namespace poinsot::job
