#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// The calm of the include graph, held by a test: arrows run down, and each foreign library is seen by one folder.
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Which folders a folder is built upon; what those are built upon it may include too. docs/architecture.md draws it.
const std::map<std::string, std::vector<std::string>> arrows = {
    {"core/base", {}},
    {"core/model", {"core/base"}},
    {"core/io", {"core/model"}},
    {"core/mesh", {"core/model"}},
    {"core/geometry", {"core/mesh"}},
    {"core/bodies", {"core/mesh"}},
    {"core/contact", {"core/bodies"}},
    {"core/effects", {"core/contact"}},
    {"core/results", {"core/mesh"}},
    {"core/solve", {"core/effects", "core/results"}},
    {"core/cases", {"core/solve"}},
    {"core/stability", {"core/cases"}},
    {"core/study", {"core/stability", "core/geometry", "core/io"}},
    {"ui/render", {"core/results"}},
    {"ui/document", {"core/model", "core/io"}},
    {"ui/run", {"core/study"}},
    {"ui/widgets", {"ui/document", "ui/run", "ui/render"}},
    {"app/cli", {"core/study", "ui/render"}},
    {"app/window", {"ui/widgets"}},
};

/// A library's headers and the only files that may include them.
struct Fence {
  std::string library;
  std::regex header;
  std::regex inside;
};

const std::vector<Fence> fences = {
    {"Qt", std::regex("Qt?[A-Z]\\w*(/.*)?|ui_.*\\.h"), std::regex("(ui/(document|run|widgets)|app/window)/.*")},
    {"VTK", std::regex("vtk.*"), std::regex("ui/render/.*|ui/widgets/(\\w*viewport\\w*|render_surface)\\.(hpp|cpp)")},
    {"OpenGL", std::regex("(GL|EGL|GLES[23]|KHR)/.*"), std::regex("ui/render/.*\\.cpp")},
    {"FFmpeg", std::regex("lib(av|sw)\\w+/.*"), std::regex("ui/render/.*\\.cpp")},
    {"giflib", std::regex("gif_lib\\.h"), std::regex("ui/render/.*\\.cpp")},
    {"libpng", std::regex("png\\.h"), std::regex("ui/render/.*\\.cpp")},
    {"gmsh", std::regex("gmsh.*\\.h(_cwrap)?"), std::regex("core/geometry/mesher/.*\\.cpp")},
    {"SuiteSparse", std::regex("(suitesparse/)?(cholmod|umfpack|SuiteSparse_config|Eigen/CholmodSupport).*"),
     std::regex("core/solve/(cholesky|sparse_lu)\\.cpp")},
    {"OpenBLAS", std::regex("cblas.*\\.h|lapacke?\\.h"), std::regex("core/solve/(cholesky|sparse_lu)\\.cpp")},
    {"oneTBB", std::regex("(oneapi/)?tbb/.*"), std::regex("core/base/parallel\\.cpp")},
    {"HDF5", std::regex("hdf5\\.h|H5\\w+\\.h"), std::regex("core/results/.*")},
    {"valijson", std::regex("valijson/.*"), std::regex("core/io/.*\\.cpp")},
    {"CLI11", std::regex("CLI/.*"), std::regex("app/.*")},
};

/// What folders show each other of core needs the standard library and Eigen only.
const std::regex standard_or_eigen("[a-z_0-9]+|Eigen/\\w+");

constexpr int longest_file = 500;  // lines

struct SourceFile {
  std::string path;  ///< from the source folder, with /
  std::string text;
};

/// What stands between the quotes or angle brackets, in the file's order.
std::vector<std::string> includes_of(const SourceFile& file, char quote) {
  const std::regex line(
      quote == '"' ? R"re(^[ \t]*#[ \t]*include[ \t]*"([^"]+)")re" : R"re(^[ \t]*#[ \t]*include[ \t]*<([^>]+)>)re",
      std::regex::ECMAScript | std::regex::multiline);
  std::vector<std::string> names;
  for (std::sregex_iterator match(file.text.begin(), file.text.end(), line), end; match != end; ++match)
    names.push_back((*match)[1]);
  return names;
}

/// The folder of core, ui or app that a path lies in.
std::string folder_of(const std::string& path) { return path.substr(0, path.find('/', path.find('/') + 1)); }

/// The folder a header "folder/file.hpp" belongs to; empty when it is none of ours.
std::string folder_of_header(const std::string& name) {
  const std::string folder = name.substr(0, name.find('/'));
  for (const std::string part : {"core/", "ui/", "app/"})
    if (arrows.contains(part + folder)) return part + folder;
  return {};
}

/// The path of a header "folder/file.hpp" of ours; empty when it is none.
std::string path_of_header(const std::string& name) {
  const std::string folder = folder_of_header(name);
  return folder.empty() ? folder : folder + name.substr(name.find('/'));
}

/// The folder itself and all it is built upon.
std::set<std::string> visible_from(const std::string& folder) {
  std::set<std::string> seen{folder};
  for (const std::string& lower : arrows.at(folder)) seen.merge(visible_from(lower));
  return seen;
}

/// All that is wrong with a file's includes and length, a line each.
std::vector<std::string> faults(const SourceFile& file) {
  std::vector<std::string> found;
  const auto add = [&](const std::string& what) { found.push_back(file.path + " " + what); };

  const std::string folder = folder_of(file.path);
  const bool known = arrows.contains(folder);
  if (!known) add("lies in a folder without arrows");

  const std::vector<std::string> system = includes_of(file, '<'), own = includes_of(file, '"');
  for (const std::string& name : own) {
    const std::string target = folder_of_header(name);
    if (known && !target.empty() && !visible_from(folder).contains(target)) add("may not include " + name);
  }
  for (const auto* names : {&system, &own})
    for (const std::string& name : *names)
      for (const Fence& fence : fences)
        if (std::regex_match(name, fence.header) && !std::regex_match(file.path, fence.inside))
          add("may not include " + name + ": " + fence.library + " has its own place");
  const auto lines = std::ranges::count(file.text, '\n');
  if (lines > longest_file) add("has " + std::to_string(lines) + " lines");
  return found;
}

using Tree = std::map<std::string, const SourceFile*>;

/// Foreign headers that a header of core brings along, itself or through others of ours.
std::set<std::string> foreign_behind(const std::string& header, const Tree& tree) {
  std::set<std::string> foreign, seen;
  std::vector<std::string> waiting{header};
  while (!waiting.empty()) {
    const std::string path = waiting.back();
    waiting.pop_back();
    if (!tree.contains(path) || !seen.insert(path).second) continue;
    for (const std::string& name : includes_of(*tree.at(path), '<'))
      if (!std::regex_match(name, standard_or_eigen)) foreign.insert(name);
    for (const std::string& name : includes_of(*tree.at(path), '"'))
      if (folder_of_header(name).empty())
        foreign.insert(name);
      else
        waiting.push_back(path_of_header(name));
  }
  return foreign;
}

/// Headers of core that show another folder more than the standard library and Eigen, a line each. A header that
/// wraps a library for its own folder alone is fine.
std::vector<std::string> leaks(const std::vector<SourceFile>& files) {
  Tree tree;
  for (const SourceFile& file : files) tree[file.path] = &file;
  std::set<std::string> found;
  for (const SourceFile& file : files)
    for (const std::string& name : includes_of(file, '"')) {
      const std::string header = path_of_header(name);
      if (!header.starts_with("core/") || folder_of(header) == folder_of(file.path)) continue;
      for (const std::string& foreign : foreign_behind(header, tree)) found.insert(header + " shows " + foreign);
    }
  return {found.begin(), found.end()};
}

/// A circle of files that include one another, as its paths in order; empty when there is none.
std::vector<std::string> circle_among(const std::vector<SourceFile>& files) {
  std::map<std::string, std::vector<std::string>> lower;
  for (const SourceFile& file : files) {
    std::vector<std::string>& targets = lower[file.path];
    for (const std::string& name : includes_of(file, '"'))
      if (const std::string path = path_of_header(name); !path.empty()) targets.push_back(path);
  }
  std::set<std::string> done;
  std::vector<std::string> trail;
  const std::function<bool(const std::string&)> closes = [&](const std::string& path) {
    if (const auto start = std::ranges::find(trail, path); start != trail.end()) {
      trail.erase(trail.begin(), start);
      return true;
    }
    if (!done.insert(path).second) return false;
    trail.push_back(path);
    if (std::ranges::any_of(lower[path], closes)) return true;
    trail.pop_back();
    return false;
  };
  for (const SourceFile& file : files)
    if (closes(file.path)) return trail;
  return {};
}

std::vector<SourceFile> source_tree() {
  const fs::path root = TALUS_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const char* part : {"core", "ui", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      files.push_back({fs::relative(entry.path(), root).generic_string(), text.str()});
    }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

TEST(Includes, OfAllFilesRunDownTheArrows) {
  const std::vector<SourceFile> files = source_tree();
  ASSERT_GT(files.size(), 15u);
  std::vector<std::string> found;
  for (const SourceFile& file : files) std::ranges::copy(faults(file), std::back_inserter(found));
  EXPECT_THAT(found, IsEmpty());
}

TEST(Includes, OfCoreShowOtherFoldersStdAndEigenOnly) { EXPECT_THAT(leaks(source_tree()), IsEmpty()); }

TEST(Includes, OfAllFilesCloseNoCircle) { EXPECT_THAT(circle_among(source_tree()), IsEmpty()); }

TEST(Includes, EveryFolderOfTheTreeHasArrows) {
  const fs::path root = TALUS_SOURCE_DIR;
  for (const auto& [folder, lower] : arrows)
    for (const std::string& name : lower) EXPECT_TRUE(arrows.contains(name)) << folder << " → " << name;
  for (const char* part : {"core", "ui", "app"})
    for (const auto& entry : fs::directory_iterator(root / part)) {
      if (!entry.is_directory()) continue;
      EXPECT_TRUE(arrows.contains(fs::relative(entry.path(), root).generic_string())) << entry.path();
    }
}

// The checks above mean something only if they can fail.
TEST(Includes, AnArrowThatRunsUpIsFound) {
  EXPECT_THAT(faults({"core/base/error.hpp", "#pragma once\n#include \"model/project.hpp\"\n"}),
              ElementsAre("core/base/error.hpp may not include model/project.hpp"));
  EXPECT_THAT(faults({"core/results/frame.cpp", "  #  include \"solve/run.hpp\"\n"}), SizeIs(1));
  EXPECT_THAT(faults({"ui/render/scene.cpp", "#include \"solve/run.hpp\"\n"}), SizeIs(1));
  EXPECT_THAT(faults({"core/solve/run.cpp", "#include \"base/units.hpp\"\n#include \"results/frame.hpp\"\n"}),
              IsEmpty());
}

TEST(Includes, ALibraryOutsideItsFenceIsFound) {
  EXPECT_THAT(faults({"core/solve/run.cpp", "#include <QString>\n"}),
              ElementsAre("core/solve/run.cpp may not include QString: Qt has its own place"));
  EXPECT_THAT(faults({"ui/render/scene.cpp", "#include <QtCore/QObject>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"ui/widgets/timeline.cpp", "#include <vtkActor.h>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"ui/widgets/gl_viewport.cpp", "#include <QMouseEvent>\n#include <vtkActor.h>\n"}), IsEmpty());
  EXPECT_THAT(faults({"core/solve/sparse_pattern.cpp", "#include <cholmod.h>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"core/solve/cholesky.cpp", "#include <cholmod.h>\n"}), IsEmpty());
  EXPECT_THAT(faults({"core/mesh/quality.cpp", "#include <gmsh.h>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"app/cli/main.cpp", "#include <hdf5.h>\n"}), SizeIs(1));
}

TEST(Includes, AHeaderThatShowsOthersMoreThanStdAndEigenIsFound) {
  const SourceFile wrapper{"core/results/hdf5.hpp", "#include <hdf5.h>\n"};
  const SourceFile writer{"core/results/result_writer.cpp", "#include \"results/hdf5.hpp\"\n"};
  const SourceFile folder{"core/results/result_folder.hpp", "#include <string>\n#include <Eigen/Core>\n"};
  const SourceFile leaking{"core/results/result_folder.hpp", "#include \"results/hdf5.hpp\"\n"};
  const SourceFile user{"core/solve/run.cpp", "#include \"results/result_folder.hpp\"\n"};
  EXPECT_THAT(leaks({wrapper, writer, folder, user}), IsEmpty());
  EXPECT_THAT(leaks({wrapper, leaking, user}), ElementsAre("core/results/result_folder.hpp shows hdf5.h"));
}

TEST(Includes, AFileOfMoreThan500LinesIsFound) {
  EXPECT_THAT(faults({"core/mesh/surface.cpp", std::string(500, '\n')}), IsEmpty());
  EXPECT_THAT(faults({"core/mesh/surface.cpp", std::string(501, '\n')}),
              ElementsAre("core/mesh/surface.cpp has 501 lines"));
}

TEST(Includes, ACircleIsFound) {
  EXPECT_THAT(circle_among({{"core/mesh/block.hpp", "#include \"mesh/surface.hpp\"\n"},
                            {"core/mesh/surface.cpp", "#include \"mesh/surface.hpp\"\n"},
                            {"core/mesh/surface.hpp", "#include \"mesh/block.hpp\"\n"}}),
              ElementsAre("core/mesh/block.hpp", "core/mesh/surface.hpp"));
  EXPECT_THAT(circle_among({{"core/mesh/block.hpp", "#include \"mesh/surface.hpp\"\n"},
                            {"core/mesh/surface.cpp", "#include \"mesh/surface.hpp\"\n"}}),
              IsEmpty());
}

}  // namespace
