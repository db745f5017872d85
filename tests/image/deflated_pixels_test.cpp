// SPDX-License-Identifier: Apache-2.0
// The same pixels must give the same bytes at any address in memory. ISA-L alone does not guarantee that (see
// kFirstBytes): for this picture, some 20 of 400 addresses gave other bytes. libpng checks the pixels themselves
// in png_file_test.cpp.
#include "image/deflated_pixels.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/mman.h>

#include <functional>
#include <random>
#include <set>
#include <vector>

namespace poinsot::image {
namespace {

constexpr std::size_t kStackBytes = 1 << 20;

/// Memory for many stacks; the system provides only the pages that are used.
class Stacks {
 public:
  explicit Stacks(std::size_t count)
      : bytes_(count * kStackBytes),
        at_(mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {}
  Stacks(const Stacks&) = delete;
  Stacks& operator=(const Stacks&) = delete;
  ~Stacks() {
    if (given()) munmap(at_, bytes_);
  }

  bool given() const { return at_ != MAP_FAILED; }

  /// Runs `what` in a thread on the i-th stack. Returns false if no thread could be started.
  bool run(std::size_t i, std::function<void()> what) const {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstack(&attributes, static_cast<char*>(at_) + i * kStackBytes, kStackBytes);
    const auto call = [](void* function) -> void* {
      (*static_cast<std::function<void()>*>(function))();
      return nullptr;
    };
    pthread_t thread;
    const bool started = pthread_create(&thread, &attributes, call, &what) == 0;
    if (started) pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return started;
  }

 private:
  std::size_t bytes_;
  void* at_;
};

/// Returns a picture whose colour changes every few pixels, by the same amount twice. As differences, the picture
/// has strings of bytes that appear only there, and twice within a few bytes.
Image steps() {
  Image picture({6'000, 11}, 3);
  std::vector<std::uint8_t> by(picture.pixels.size());
  std::mt19937 random(2);
  for (std::size_t i = 0; i + 20 < by.size(); i += 16 + random() % 32) {
    const std::size_t again = i + 3 + random() % 6;
    for (std::size_t k = 0; k < 3; ++k) by[i + k] = by[again + k] = static_cast<std::uint8_t>(random());
  }
  for (std::size_t i = 3; i < by.size(); ++i)
    picture.pixels[i] = static_cast<std::uint8_t>(picture.pixels[i - 3] + by[i]);
  return picture;
}

TEST(DeflatedPixels, AreTheSameAtAnyAddressInMemory) {
  constexpr std::size_t kPlaces = 400;
  const Stacks stacks(kPlaces);
  ASSERT_TRUE(stacks.given());
  const Image picture = steps();
  std::set<std::vector<std::uint8_t>> made;
  for (std::size_t i = 0; i < kPlaces; ++i)
    ASSERT_TRUE(stacks.run(i, [&] { made.insert(deflatedPixels(picture)); }));
  EXPECT_EQ(made.size(), 1u);
}

}  // namespace
}  // namespace poinsot::image
