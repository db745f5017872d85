// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fuzz/input.h"
#include "job/job_record.h"
#include "job/segment_record.h"
#include "suite/reference.h"

namespace {

using namespace poinsot;

const request::OutputTarget kFilm{request::OutputKind::kFilm, "film.mp4"};
const request::OutputTarget kSequence{request::OutputKind::kSequence, "f_{frame:03}.png"};

void readJob(std::string_view text, const request::OutputTarget& target) {
  const auto job = job::parseJobRecord(text, target);
  if (!job) return;
  // A million segments would take a second.
  if (job->frames.count() / job->segmentFrames < 1000) request::segmentsOf({1, 1}, job->segments());
}

void readRecord(std::string_view text, const request::OutputTarget& target) {
  const auto record = job::SegmentRecords(".work", target).parse(text, {0, 2});
  if (!record) return;
  const auto files = job::segmentFiles(".work", target, {0, 2});
  const bool own = std::ranges::equal(record->files, files, {}, &job::RecordedFile::path);
  if (!own || record->digests.size() != 3) std::abort();
}

}  // namespace

// The input is a byte that selects the kind of file, then a JSON file of a work folder or of a reference picture.
// A malformed file counts as missing: nothing is thrown.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text = fuzz::textOf({data + 1, size - 1});
  const request::OutputTarget& target = data[0] == 'J' || data[0] == 'R' ? kFilm : kSequence;
  if (data[0] == 'J' || data[0] == 'j') readJob(text, target);
  if (data[0] == 'R' || data[0] == 'r') readRecord(text, target);
  if (data[0] == 'o') suite::parsePictureOrigin(text);
  return 0;
}
