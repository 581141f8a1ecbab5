#include "removability/block_rule.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <numeric>
#include <set>
#include <string_view>

namespace talus {

namespace {

bool is_on(Side side, double value, double limit) { return side == Side::below ? value < limit : value > limit; }

/// Greedy, with one place to go back to: a star that has to take a letter more.
bool is_like(std::string_view name, std::string_view pattern) {
  std::size_t n = 0, p = 0, star = std::string_view::npos, taken = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::string in_small_letters(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/// Whether a block is meant; `facts` are of the same block.
struct Meaning {
  const Block& block;
  const BlockFacts& facts;

  bool operator()(const ByVolume& rule) const { return is_on(rule.side, block.volume, rule.volume); }
  bool operator()(const ByThickness& rule) const { return 2 * block.volume < rule.below * facts.area; }
  bool operator()(const ByPlane& rule) const {
    return is_on(rule.side, rule.normal.dot(facts.centroid), rule.normal.dot(rule.through));
  }
  bool operator()(const ByJoint& rule) const {
    return std::binary_search(facts.joints.begin(), facts.joints.end(), rule.joint);
  }
  bool operator()(const ByFreeFace&) const { return facts.free_faces > 0; }
  bool operator()(const ByRemovability& rule) const {
    const Removability& leaving = facts.leaving;
    if (facts.fixed || !leaving.removable()) return false;
    if (rule.mode && *rule.mode != leaving.leaving) return false;
    return !rule.factor_below || (leaving.factor && *leaving.factor < *rule.factor_below);
  }
  bool operator()(const ByBody& rule) const { return block.body == rule.body; }
  bool operator()(const ByMaterial& rule) const { return block.material == rule.material; }
  bool operator()(const BySolid& rule) const { return block.solid == rule.solid; }
  bool operator()(const ByName& rule) const {
    std::string pattern = in_small_letters(rule.pattern);
    if (pattern.find_first_of("*?") == std::string::npos) pattern = "*" + pattern + "*";
    return is_like(in_small_letters(block.name), pattern);
  }
};

}  // namespace

std::vector<int> blocks_by(const BlockRule& rule, const BlockSystem& system, const std::vector<BlockFacts>& facts) {
  std::vector<int> found;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    if (std::visit(Meaning{system.blocks[b], facts[b]}, rule)) found.push_back(static_cast<int>(b));
  return found;
}

std::vector<int> combined(const std::vector<int>& selected, const std::vector<int>& found, Combination how) {
  std::vector<int> result;
  const auto into = std::back_inserter(result);
  switch (how) {
    case Combination::replace:
      return found;
    case Combination::add:
      std::set_union(selected.begin(), selected.end(), found.begin(), found.end(), into);
      break;
    case Combination::remove:
      std::set_difference(selected.begin(), selected.end(), found.begin(), found.end(), into);
      break;
    case Combination::within:
      std::set_intersection(selected.begin(), selected.end(), found.begin(), found.end(), into);
      break;
  }
  return result;
}

std::vector<int> inverted(const std::vector<int>& selected, int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return combined(all, selected, Combination::remove);
}

std::vector<int> grown(const std::vector<int>& selected, const std::vector<BlockFacts>& facts) {
  std::set<int> larger(selected.begin(), selected.end());
  for (const int block : selected) {
    const auto& neighbours = facts[static_cast<std::size_t>(block)].neighbours;
    larger.insert(neighbours.begin(), neighbours.end());
  }
  return {larger.begin(), larger.end()};
}

std::vector<std::pair<int, int>> joining_pairs(const std::vector<int>& blocks, const std::vector<BlockFacts>& facts) {
  if (blocks.size() < 2) return {};
  std::set<int> left(blocks.begin() + 1, blocks.end());
  std::vector<int> joined{blocks.front()};
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t next = 0; next < joined.size(); ++next)
    for (const int neighbour : facts[static_cast<std::size_t>(joined[next])].neighbours)
      if (left.erase(neighbour) > 0) {
        pairs.emplace_back(joined[next], neighbour);
        joined.push_back(neighbour);
      }
  return left.empty() ? pairs : std::vector<std::pair<int, int>>{};
}

}  // namespace talus
