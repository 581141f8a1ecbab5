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
  const std::regex line(
      quote == '"' ? R"re(^[ \t]*#[ \t]*include[ \t]*"([^"]+)")re" : R"re(^[ \t]*#[ \t]*include[ \t]*<([^>]+)>)re",
      std::regex::ECMAScript | std::regex::multiline);
  std::vector<std::string> names;
  for (std::sregex_iterator match(file.text.begin(), file.text.end(), line), end; match != end; ++match)
    names.push_back((*match)[1]);
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
