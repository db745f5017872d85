// SPDX-License-Identifier: Apache-2.0
#include "gl/offscreen_context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "gl/framebuffer.h"
#include "gl/shader_program.h"
#include "gl/storage.h"
#include "support/back_ends.h"

namespace poinsot::gl {
namespace {

using testing::HasSubstr;

class OffscreenContextTest : public testing::TestWithParam<Backend> {
 protected:
  static void SetUpTestSuite() { pinEnvironment(true); }
  std::unique_ptr<OffscreenContext> context_ = openContext(GetParam());
};

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kGraphics);
    return error.message();
  }
  return "no error";
}

TEST_P(OffscreenContextTest, UsesLlvmpipe) {
  EXPECT_THAT(context_->renderer(), HasSubstr("llvmpipe"));
  EXPECT_FALSE(context_->version().empty());
}

TEST_P(OffscreenContextTest, ClearsAndReadsBack) {
  const Framebuffer target({3, 2}, {GL_RGBA8}, 0);
  target.bind();
  glClearColor(1.0f, 0.2f, 0.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  unsigned char pixels[3 * 2 * 4] = {};
  glReadPixels(0, 0, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(pixels[4 * i], 255);
    EXPECT_EQ(pixels[4 * i + 1], 51);  // 0.2 * 255
    EXPECT_EQ(pixels[4 * i + 2], 0);
  }
}

// Every driver refuses an exbibyte; the message is poinsot's own.
TEST_P(OffscreenContextTest, ReportsThatABufferDoesNotFit) {
  const BufferName buffer = BufferName::make();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, 16, nullptr, GL_STATIC_DRAW);
  EXPECT_EQ(messageOf([] { expectStored("a buffer", 16); }), "no error");
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr{1} << 60, nullptr, GL_STATIC_DRAW);
  EXPECT_EQ(messageOf([] { expectStored("a buffer", std::size_t{1} << 60); }),
            "the back end cannot hold a buffer of 1152921504606846976 bytes: out of memory (error 0x505)");
}

TEST_P(OffscreenContextTest, AShaderErrorNamesTheShaderAndTheLine) {
  const std::string vertex = "void main() { gl_Position = vec4(0.0); }\n";
  const auto message =
      messageOf([&] { ShaderProgram("broken.frag", vertex, "out vec4 c;\nvoid main() { c = nonsense; }\n"); });
  EXPECT_THAT(message, HasSubstr("broken.frag (fragment shader)"));
  EXPECT_THAT(message, HasSubstr("nonsense"));
}

// llvmpipe's limit is 16 384 pixels a side.
TEST_P(OffscreenContextTest, TooLargeAPictureIsAnErrorNotACrash) {
  EXPECT_THAT(messageOf([] { Framebuffer({20000, 20000}, {GL_RGBA8}, 0); }), HasSubstr("20000 x 20000"));
}

INSTANTIATE_TEST_SUITE_P(BackEnds, OffscreenContextTest, testing::ValuesIn(backEnds()),
                         [](const auto& backend) { return testName(backend.param); });

/// Back end and environment variable. The variable makes Mesa report success and draw nothing, or outlines only;
/// it is set after the environment was cleared.
class UndrawnPicture : public testing::TestWithParam<std::tuple<Backend, std::pair<const char*, const char*>>> {
 protected:
  [[noreturn]] static void openAndExit() {
    const auto& [backend, variable] = GetParam();
    pinEnvironment(true);
    setenv(variable.first, variable.second, 1);
    std::fputs(messageOf([named = backend] { openContext(named); }).c_str(), stderr);
    std::exit(0);
  }
};

TEST_P(UndrawnPicture, IsReportedWhenTheContextOpens) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a new process, as Mesa reads its variables once
  EXPECT_EXIT(openAndExit(), testing::ExitedWithCode(0), "the back end reports success but does not draw");
}

using Variable = std::pair<const char*, const char*>;
INSTANTIATE_TEST_SUITE_P(
    Each, UndrawnPicture,
    testing::Combine(testing::ValuesIn(backEnds()),
                     testing::Values(Variable("LP_NO_RAST", "1"), Variable("ST_DEBUG", "wf"))),
    [](const auto& undrawn) { return testName(std::get<0>(undrawn.param)) + std::get<1>(undrawn.param).first; });

TEST(ProbeBackends, ReportsOsMesaAndEgl) {
  const auto reports = probeBackends();
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].name, "osmesa");
  EXPECT_EQ(reports[1].name, "egl");
  EXPECT_EQ(reports[0].works, hasOsMesa()) << reports[0].detail;
  EXPECT_TRUE(reports[1].works) << reports[1].detail;
}

TEST(PinEnvironment, ClearsOnlyVariablesThatMesaReads) {
  setenv("GALLIUM_DRIVER", "softpipe", 1);
  constexpr std::array kMesas{"LP_NATIVE_VECTOR_WIDTH",
                              "LP_NO_RAST",
                              "GALLIUM_NOOP",
                              "ST_DEBUG",
                              "DRAW_USE_LLVM",
                              "MESA_GLSL",
                              "MESA_OF_A_LATER_RELEASE",
                              "__EGL_VENDOR_LIBRARY_DIRS"};
  constexpr std::array kTheHosts{"FREETYPE_PROPERTIES", "STANDARD_OF_ITS_OWN"};
  for (const char* name : kMesas) setenv(name, "1", 1);
  for (const char* name : kTheHosts) setenv(name, "its", 1);
  pinEnvironment(true);
  for (const char* name : kMesas) EXPECT_EQ(std::getenv(name), nullptr) << name;
  for (const char* name : kTheHosts) {
    EXPECT_STREQ(std::getenv(name), "its");
    unsetenv(name);
  }
  EXPECT_STREQ(std::getenv("GALLIUM_DRIVER"), "llvmpipe");
  EXPECT_STREQ(std::getenv("GALLIUM_OVERRIDE_CPU_CAPS"), "sse4.1");
  pinEnvironment(false, 3);
  EXPECT_EQ(std::getenv("GALLIUM_OVERRIDE_CPU_CAPS"), nullptr);
  EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "3");
}

}  // namespace
}  // namespace poinsot::gl
