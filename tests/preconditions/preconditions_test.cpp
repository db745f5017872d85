// SPDX-License-Identifier: Apache-2.0
// docs/library.md promises that a broken @pre of an installed header throws std::logic_error. These tests break
// each precondition.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "preconditions/breaches.h"
#include "support/text_of.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> namesIn(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    names.push_back((*match)[1]);
  return names;
}

/// Returns the public headers and all headers that they include, as InstallHeaders.cmake collects them.
std::set<std::string> installedHeaders() {
  std::vector<std::string> waiting =
      namesIn(textOf(POINSOT_SOURCE_DIR "/cmake/PublicHeaders.cmake"), R"(\b(\w+/\w+\.h)\b)");
  std::set<std::string> done;
  while (!waiting.empty()) {
    const std::string header = waiting.back();
    waiting.pop_back();
    if (!done.insert(header).second) continue;
    for (const std::string& included :
         namesIn(textOf(POINSOT_SOURCE_DIR "/src/" + header), R"re(#include "([^"]+)")re"))
      waiting.push_back(included);
  }
  return done;
}

/// Returns the text after each @pre of a header, to the end of its comment or the next tag, on one line.
std::vector<std::string> preconditions(const std::string& header) {
  std::vector<std::string> found;
  bool open = false;
  std::istringstream lines(textOf(POINSOT_SOURCE_DIR "/src/" + header));
  for (std::string line; std::getline(lines, line);) {
    const auto comment = line.find("///");
    std::string words = comment == line.npos ? "" : line.substr(comment + 3);
    open = open && comment != line.npos && words.find_first_not_of(' ') == 1;
    for (std::smatch tag; std::regex_search(words, tag, std::regex(R"(@(\w+) ?)"));) {
      if (open) found.back() += tag.prefix();
      open = tag[1] == "pre";
      if (open) found.emplace_back();
      words = tag.suffix();
    }
    if (open) found.back() += words;
  }
  return found;
}

std::vector<Breach> allBreaches() {
  std::vector<Breach> all = breachesOfValues(), more = breachesOfPictures();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(Preconditions, ThrowALogicErrorWhenBroken) {
  for (const Breach& breach : allBreaches()) {
    SCOPED_TRACE(breach.header + ": " + breach.condition);
    try {
      breach.commit();
      ADD_FAILURE() << "went unnoticed";
    } catch (const std::out_of_range& error) {
      EXPECT_THAT(error.what(), HasSubstr("__n (which is "));  // message of std::vector::at
    } catch (const std::logic_error& error) {
      EXPECT_THAT(error.what(), StartsWith("broken contract: "));
    } catch (const std::exception& error) {
      ADD_FAILURE() << "another exception: " << error.what();
    }
  }
}

TEST(Preconditions, AreTestedForEveryInstalledHeader) {
  const std::vector<Breach> breaches = allBreaches();
  std::size_t seen = 0;
  for (const std::string& header : installedHeaders())
    for (const std::string& condition : preconditions(header)) {
      ++seen;
      EXPECT_TRUE(std::ranges::any_of(breaches,
                                      [&](const Breach& breach) {
                                        return breach.header == header &&
                                               condition.find(breach.condition) != condition.npos;
                                      }))
          << header << ": @pre " << condition;
    }
  EXPECT_GE(seen, 60u);  // 79 when this was written
}

TEST(Preconditions, AllTestedConditionsExistInTheHeaders) {
  for (const Breach& breach : allBreaches()) {
    const std::vector<std::string> conditions = preconditions(breach.header);
    EXPECT_TRUE(std::ranges::any_of(
        conditions,
        [&](const std::string& condition) { return condition.find(breach.condition) != condition.npos; }))
        << breach.header << ": " << breach.condition;
  }
}

}  // namespace
}  // namespace poinsot
