#include "model/suggestion.hpp"

#include <algorithm>
#include <cctype>

namespace talus {
namespace {

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Letters to insert, remove, change or swap with their neighbour to come from `a` to `b`.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 64;  // nobody mistypes a longer name into one of ours; keeps hostile input cheap
  if (name.size() > longest) return {};
  const std::string wanted = lower_case(name);
  std::string nearest;
  std::size_t fewest = 0;
  for (const auto& candidate : candidates) {
    if (candidate.size() > longest) continue;
    const std::size_t distance = edit_distance(wanted, lower_case(candidate));
    if (3 * distance > std::max(name.size(), candidate.size())) continue;
    if (nearest.empty() || distance < fewest) {
      nearest = candidate;
      fewest = distance;
    }
  }
  return nearest;
}

std::string suggest_name(const std::string& name, const std::vector<std::string>& candidates) {
  if (const std::string nearest = nearest_name(name, candidates); !nearest.empty()) {
    return "did you mean '" + nearest + "'?";
  }
  if (candidates.empty()) return {};
  constexpr std::size_t most = 12;
  std::string text = "use one of ";
  for (std::size_t i = 0; i < std::min(most, candidates.size()); ++i) text += (i ? ", " : "") + candidates[i];
  return candidates.size() > most ? text + ", …" : text;
}

}  // namespace talus
