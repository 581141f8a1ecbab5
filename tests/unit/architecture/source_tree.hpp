#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// The source as text, for the tests that hold it to its rules.

struct SourceFile {
  std::string path;  ///< from the source folder, with /
  std::string text;
};

/// What stands between the quotes or angle brackets, in the file's order.
inline std::vector<std::string> includes_of(const SourceFile& file, char quote) {
  static const std::regex own(R"re(^[ \t]*#[ \t]*include[ \t]*"([^"]+)")re");
  static const std::regex foreign(R"re(^[ \t]*#[ \t]*include[ \t]*<([^>]+)>)re");
  std::vector<std::string> names;
  std::istringstream text(file.text);
  std::smatch match;
  for (std::string line; std::getline(text, line);)
    if (line.find('#') != std::string::npos && std::regex_search(line, match, quote == '"' ? own : foreign))
      names.push_back(match[1]);
  return names;
}

/// The folder that a path lies in.
inline std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/')); }

/// All headers and sources of core, ui and app, by path.
inline std::vector<SourceFile> source_tree() {
  const std::filesystem::path root = TALUS_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const char* part : {"core", "ui", "app"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / part)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      files.push_back({std::filesystem::relative(entry.path(), root).generic_string(), text.str()});
    }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}
