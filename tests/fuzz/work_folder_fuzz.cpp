// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/golden_reference.h"
#include "app/job_file.h"
#include "app/segment_record.h"
#include "fuzz/input.h"

namespace {

using namespace poinsot;

const app::OutputTarget kFilm{app::OutputKind::kFilm, "film.mp4"};
const app::OutputTarget kSequence{app::OutputKind::kSequence, "f_{frame:03}.png"};

void readJob(std::string_view text, const app::OutputTarget& target) {
  const auto job = app::parseJobFile(text, target);
  if (!job) return;
  // With a million of them each input would take a second.
  if (job->frames.count() / job->segmentFrames < 1000) app::segmentsOf({1, 1}, job->segments());
}

void readRecord(std::string_view text, const app::OutputTarget& target) {
  const auto record = app::SegmentRecords(".work", target).parse(text, {0, 2});
  if (!record) return;
  const auto files = app::segmentFiles(".work", target, {0, 2});
  const bool own = std::ranges::equal(record->files, files, {}, &app::RecordedFile::path);
  if (!own || record->digests.size() != 3) std::abort();
}

}  // namespace

// A byte that says what it is, then a file of JSON that lies in a work folder or beside a reference picture. What
// cannot be understood is as good as missing: nothing is thrown.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text = fuzz::textOf({data + 1, size - 1});
  const app::OutputTarget& target = data[0] == 'J' || data[0] == 'R' ? kFilm : kSequence;
  if (data[0] == 'J' || data[0] == 'j') readJob(text, target);
  if (data[0] == 'R' || data[0] == 'r') readRecord(text, target);
  if (data[0] == 'o') app::parseGoldenOrigin(text);
  return 0;
}
