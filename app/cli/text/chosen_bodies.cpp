#include "text/chosen_bodies.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "mesh/block.hpp"
#include "text/table.hpp"

namespace talus::cli {

namespace {

struct Choice {
  std::string what;
  std::vector<std::string> blocks;
};

/// In the order in which the blocks come.
std::vector<Choice> choices_of(const BlockSystem& system) {
  std::vector<Choice> choices;
  for (const Block& block : system.blocks) {
    if (block.body_reason.empty()) continue;
    const std::string what = std::string(to_string(block.body)) + ": " + block.body_reason;
    const auto same = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.what == what; });
    Choice& choice = same == choices.end() ? choices.emplace_back(Choice{what, {}}) : *same;
    choice.blocks.push_back(block.name);
  }
  return choices;
}

std::string lines_of(const std::vector<std::string>& pieces, std::size_t indent) {
  std::string text;
  for (const std::string& line : wrapped(pieces, line_width - indent)) text += std::string(indent, ' ') + line + '\n';
  return text;
}

std::vector<std::string> with_commas(std::vector<std::string> names) {
  for (std::size_t i = 0; i + 1 < names.size(); ++i) names[i] += ',';
  return names;
}

}  // namespace

std::string chosen_bodies_text(const BlockSystem& system) {
  std::string text;
  for (const Choice& choice : choices_of(system)) {
    if (text.empty()) text = "Body auto became\n";
    text += lines_of(words_of(choice.what), 2) + lines_of(with_commas(choice.blocks), 4);
  }
  return text;
}

}  // namespace talus::cli
