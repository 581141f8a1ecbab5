#include "pictures/baseline_list.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <fstream>

#include "base/error.hpp"

namespace talus::cli {

namespace {

constexpr const char* how_to_write = "write a picture's name, results folders and options of render";

/// Without what stands behind a # that begins a word outside quotes.
std::string without_comment(const std::string& line) {
  char quote = 0, before = ' ';
  for (std::size_t i = 0; i < line.size(); before = line[i++]) {
    if (quote != 0 && line[i] == quote)
      quote = 0;
    else if (quote == 0 && (line[i] == '"' || line[i] == '\''))
      quote = line[i];
    else if (quote == 0 && line[i] == '#' && (before == ' ' || before == '\t'))
      return line.substr(0, i);
  }
  return line;
}

/// A picture of the folder, not one that lies anywhere else.
void check_name(const Baseline& baseline) {
  const std::filesystem::path name(baseline.name);
  if (name.extension() != ".png" || name.is_absolute() || std::ranges::count(name, ".."))
    throw InputError(baseline.line, "'" + baseline.name + "' is no name of a picture in this folder",
                     "write one like slope.png");
}

Baseline read_line(const std::filesystem::path& folder, const std::string& text, const std::string& place) {
  Baseline baseline;
  baseline.line = place;
  CLI::App words;
  words.set_help_flag();
  words.add_option("PICTURE", baseline.name)->required();
  add_drawing(words, baseline.drawing);
  try {
    words.parse(text);
  } catch (const CLI::ParseError& error) {
    throw InputError(place, error.what(), how_to_write);
  }
  check_name(baseline);
  baseline.file = folder / baseline.name;
  for (std::filesystem::path& results : baseline.drawing.results) results = folder / results;
  std::filesystem::path& view = baseline.drawing.look.view_file;
  if (!view.empty()) view = folder / view;
  return baseline;
}

}  // namespace

std::vector<Baseline> read_baselines(const std::filesystem::path& folder) {
  const std::filesystem::path list = folder / "baselines.txt";
  std::ifstream lines(list);
  if (!lines)
    throw InputError(list.string(), "cannot be read", "make this list of pictures, or name the folder that has one");
  std::vector<Baseline> baselines;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string text = without_comment(line);
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    Baseline next = read_line(folder, text, list.string() + ": line " + std::to_string(number));
    if (std::ranges::count(baselines, next.name, &Baseline::name))
      throw InputError(next.line, "there are two pictures of the name " + next.name, "give one of them another name");
    baselines.push_back(std::move(next));
  }
  if (baselines.empty()) throw InputError(list.string(), "names no picture", how_to_write);
  return baselines;
}

}  // namespace talus::cli
