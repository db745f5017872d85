// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/similar_keys.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/text.h"
#include "scene/keys/foreign_names.h"
#include "scene/keys/unknown_key.h"

namespace poinsot::scene {
namespace {

constexpr std::size_t kMostSimilar = 3;

// Words with the same meaning. The first word of a group stands for all.
constexpr auto kSynonyms = std::to_array<std::string_view>({
    "film movie video clip animation",
    "duration length span interval long",
    "speed playback slow slowdown fast faster slower pace",
    "spin rotation rotate rotating rotational turn revolution turning",
    "omega angular velocity rate rates",
    "tilt wobble obliquity",
    "lean inclination inclined leaning",
    "moment moments inertia",
    "body object solid",
    "azimuth heading",
    "elevation altitude",
    "zoom magnification scale",
    "colour color colors colours",
    "paper background canvas",
    "ink text foreground",
    "axes axis",
    "arrow vector vectors arrows",
    "trace trail path locus trajectory curve",
    "caption comment annotation",
    "title heading name",
    "gravity gravitational",
    "torque moments force",
    "drag friction damping resistance viscous air",
    "dissipation loss losses internal",
    "velocity throw thrown launch toss",
    "flight ballistic parabola",
    "fps frames frame",
    "size extent extents dimensions resolution width",
    "quality crf bitrate",
    "visible show shown draw drawn display",
    "opacity alpha transparency transparent",
    "start initial begin beginning first",
    "mass weight",
    "pivot fixed hinge support",
    "centre center middle",
    "radius diameter",
    "momentum momenta",
    "energy kinetic",
    "orbit orbiting around",
    "follow track tracking",
    "label labels names",
    "theme dark light",
    "hold pause freeze halt standstill",
    "loop repeat seamless cyclic periodic",
    "line lines stroke",
});

// Words that say nothing about the key, and units.
constexpr std::string_view kEmpty =
    " the a an of and or in is it to by for with that this are if as at on from its be not no than two one value "
    "use "
    "set get enable enabled is has my param parameter type mode deg degs degree degrees rad radians rps rpm hz ms "
    "sec "
    "secs second seconds min minute minutes hour hours h kg g cm mm km m s kgm2 si unit units number default ";

std::string_view meaningOf(std::string_view word) {
  static const auto meanings = [] {
    std::map<std::string_view, std::string_view> map;
    for (std::string_view group : kSynonyms) {
      const std::string_view first = group.substr(0, group.find(' '));
      while (!group.empty()) {
        const std::size_t end = std::min(group.find(' '), group.size());
        map.emplace(group.substr(0, end), first);
        group.remove_prefix(std::min(end + 1, group.size()));
      }
    }
    return map;
  }();
  const auto found = meanings.find(word);
  return found == meanings.end() ? std::string_view() : found->second;
}

std::string stemOf(const std::string& word) {
  if (const auto meaning = meaningOf(word); !meaning.empty()) return std::string(meaning);
  std::string stem = word;
  if (stem.size() > 3 && stem.ends_with('s') && !stem.ends_with("ss")) stem.pop_back();
  const auto meaning = meaningOf(stem);
  return meaning.empty() ? stem : std::string(meaning);
}

/// Returns the words of a name or a text, each as the word that stands for its synonyms. Splits camelCase.
std::vector<std::string> wordsIn(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (word.size() > 1 && kEmpty.find(" " + word + " ") == std::string_view::npos) words.push_back(stemOf(word));
    word.clear();
  };
  char before = ' ';
  for (const char c : text) {
    const bool capital = c >= 'A' && c <= 'Z', small = c >= 'a' && c <= 'z';
    if ((!capital && !small) || (capital && before >= 'a' && before <= 'z')) finish();
    if (capital || small) word += capital ? static_cast<char>(c - 'A' + 'a') : c;
    before = c;
  }
  finish();
  return words;
}

using Weights = std::map<std::string, double, std::less<>>;

void weigh(Weights& weights, std::string_view text, double weight) {
  for (std::string& word : wordsIn(text)) {
    double& known = weights[std::move(word)];
    known = std::max(known, weight);
  }
}

/// Words of all keys, with their weights, and how rare each word is.
class Index {
 public:
  Index() {
    for (const Key& key : keys())
      if (!repeatsInView(key)) add(key);
    addForeignNames();
    for (const auto& [key, weights] : weights_)
      for (const auto& [word, weight] : weights)
        if (weight >= kHelp) ++counts_[word];
  }

  const std::map<const Key*, Weights>& all() const { return weights_; }

  double rarity(std::string_view word) const {
    const auto found = counts_.find(word);
    const double count = found == counts_.end() ? 0 : found->second;
    return std::log((1 + static_cast<double>(weights_.size())) / (1 + count));
  }

 private:
  static constexpr double kName = 1, kForeign = 0.8, kTable = 0.6, kHelp = 0.5, kRestOfHelp = 0.25;

  void add(const Key& key) {
    Weights& weights = weights_[&key];
    const std::string_view help = key.help, table = tableOf(key.path);
    const std::size_t sentence = std::min(help.find(". "), help.size());
    weigh(weights, nameOf(key.path), kName);
    if (nameOf(key.path) == "visible") weigh(weights, nameOf(table), kName);
    weigh(weights, table, kTable);
    weigh(weights, help.substr(0, sentence), kHelp);
    weigh(weights, help.substr(sentence), kRestOfHelp);
  }

  void addForeignNames() {
    for (const ForeignNames& row : foreignNames())
      if (const Key* key = row.key.empty() || row.carry == Carry::kLaunch ? nullptr : findKey(row.key);
          weights_.contains(key))
        for (const std::string_view name : namesIn(row))
          if (name.size() > 3) weigh(weights_[key], nameOf(name), kForeign);
  }

  std::map<const Key*, Weights> weights_;
  std::map<std::string, double, std::less<>> counts_;
};

std::string_view topTable(std::string_view path) { return path.substr(0, path.find_first_of(".[")); }

/// Returns a factor for a key in another table. The look of a picture never leads to physics.
double nearness(std::string_view table, const Key& key) {
  const std::string_view own = topTable(table), other = topTable(key.path);
  if (tableOf(key.path) == patternOf(table)) return 1.3;
  if (own == other) return 1.15;
  const auto isPhysics = [](std::string_view top) { return top == "body" || top == "motion"; };
  const bool isKnown = isTable(own) || isTableArray(own);
  if (isKnown && isPhysics(own) != isPhysics(other)) return 0.5;
  return isKnown ? 0.8 : 1;
}

}  // namespace

std::vector<const Key*> similarKeys(std::string_view path, const std::function<bool(const Key&)>& takes) {
  constexpr double kLeast = 0.42, kLeastOfBest = 0.8;
  if (nameOf(path).size() > kLongestName) return {};
  static const Index index;
  std::vector<std::string> words = wordsIn(nameOf(path));
  double most = 0;
  for (const std::string& word : words) most += index.rarity(word);
  if (words.empty() || most == 0) return {};
  std::vector<std::pair<double, const Key*>> scores;
  for (const auto& [key, weights] : index.all()) {
    double score = 0;
    for (const std::string& word : words)
      if (const auto found = weights.find(word); found != weights.end())
        score += found->second * index.rarity(word);
    const bool isElement = key->path.find('[') != std::string::npos;
    if (score < 0.3 * most || (isElement && tableOf(key->path) != patternOf(tableOf(path)))) continue;
    score *= nearness(tableOf(path), *key) / most;
    if (takes) score *= takes(*key) ? 1 : 0.6;
    if (score >= kLeast) scores.emplace_back(score, key);
  }
  std::ranges::stable_sort(scores, [](const auto& a, const auto& b) {
    return a.first > b.first || (a.first == b.first && a.second->path < b.second->path);
  });
  std::vector<const Key*> best;
  for (const auto& [score, key] : scores)
    if (best.size() < kMostSimilar && score >= kLeastOfBest * scores[0].first) best.push_back(key);
  return best;
}

std::string shortHelp(const Key& key) {
  constexpr std::size_t kLongest = 60;
  std::string_view help = key.help;
  for (const std::string_view end : {". ", ": ", "; ", ", as in "}) help = help.substr(0, help.find(end));
  if (help.size() > kLongest) help = help.substr(0, help.find(", "));
  if (help.size() > kLongest) return std::string(help.substr(0, help.rfind(' ', kLongest))) + " ...";
  if (help.ends_with('.')) help.remove_suffix(1);
  return std::string(help);
}

}  // namespace poinsot::scene
