// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/reference.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scene_testing.h"

namespace poinsot::scene {
namespace {

constexpr const char* kUpdate = "POINSOT_UPDATE_DOCS=1 ctest --test-dir build -R Reference.MatchesTheTableOfKeys";

// docs/scene.md is committed, so that it can be read without a build. This test keeps it up to date.
TEST(Reference, MatchesTheTableOfKeys) {
  const std::string path = std::string(POINSOT_SOURCE_DIR) + "/docs/scene.md";
  if (std::getenv("POINSOT_UPDATE_DOCS")) std::ofstream(path) << referenceMarkdown();
  std::ostringstream committed;
  committed << std::ifstream(path).rdbuf();
  EXPECT_TRUE(committed.str() == referenceMarkdown())
      << "docs/scene.md differs from the table of keys; update it with\n  " << kUpdate;
}

TEST(Reference, BeginsWithAValidScene) {
  const std::string text = referenceMarkdown();
  const std::size_t begin = text.find("```toml\n") + 8;
  EXPECT_NO_THROW(parseScene(text.substr(begin, text.find("```", begin) - begin), "reference.toml"));
}

TEST(Schema, IsDraft4AndRejectsUnknownKeys) {
  const auto schema = nlohmann::json::parse(schemaJson());
  EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-04/schema#");
  EXPECT_EQ(schema["type"], "object");
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(schema["required"], nlohmann::json::parse(R"(["body", "motion"])"));
  EXPECT_EQ(schema["properties"]["motion"]["oneOf"][0]["required"], nlohmann::json::parse(R"(["omega_body"])"));
  EXPECT_EQ(schema["properties"]["body"]["oneOf"][0]["required"],
            nlohmann::json::parse(R"(["principal_moments"])"));
  EXPECT_EQ(schema["properties"]["body"]["properties"]["part"]["items"]["additionalProperties"], false);
  EXPECT_EQ(schema["properties"]["output"]["properties"]["size"]["items"]["multipleOf"], 2);
}

// The schema has 120 degrees in radians, rounded to nine digits.
TEST(Schema, GivesBoundsInSi) {
  const auto fov = nlohmann::json::parse(schemaJson())["properties"]["camera"]["properties"]["fov"];
  EXPECT_EQ(fov["anyOf"][0]["maximum"], 2.0943951);
  EXPECT_EQ(fov["default"], "24 deg");
}

}  // namespace
}  // namespace poinsot::scene
