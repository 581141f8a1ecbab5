#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "source_tree.hpp"

// The calm of the include graph, held by a test: arrows run down, and each foreign library is seen by one folder.
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Which folders a folder is built upon; what those are built upon it may include too. docs/architecture.md draws it.
const std::map<std::string, std::vector<std::string>> arrows = {
    {"core/base", {}},
    {"core/model/rock", {"core/base"}},
    {"core/model", {"core/model/rock"}},
    {"core/model/rules", {"core/model"}},
    {"core/orientation", {"core/model"}},
    {"core/io", {"core/model/rules"}},
    {"core/templates", {"core/model"}},
    {"core/mesh", {"core/model"}},
    {"core/removability", {"core/mesh"}},
    {"core/geometry", {"core/mesh", "core/orientation", "core/model/rules"}},
    {"core/geometry/mesher/surfaces", {"core/geometry"}},
    {"core/geometry/mesher", {"core/geometry/mesher/surfaces"}},
    {"core/geometry/mesher/cells", {"core/geometry/mesher"}},
    {"core/geometry/mesher/blocks", {"core/geometry/mesher/cells"}},
    {"core/linear", {"core/base"}},
    {"core/bodies", {"core/mesh", "core/linear"}},
    {"core/contact", {"core/bodies"}},
    {"core/contact/broad", {"core/contact"}},
    {"core/contact/history", {"core/contact"}},
    {"core/contact/narrow", {"core/contact/broad", "core/contact/history"}},
    {"core/contact/detection", {"core/contact/narrow"}},
    {"core/contact/passage", {"core/contact/broad"}},
    {"core/effects", {"core/contact"}},
    {"core/results", {"core/mesh"}},
    {"core/fields", {"core/results", "core/bodies"}},
    {"core/measures", {"core/fields"}},
    {"core/export", {"core/measures"}},
    {"core/solve/equilibrium", {"core/effects"}},
    {"core/solve/dynamics", {"core/effects"}},
    {"core/solve",
     {"core/solve/equilibrium", "core/solve/dynamics", "core/contact/detection", "core/contact/passage",
      "core/results"}},
    {"core/run", {"core/solve"}},
    {"core/verification/known_answers/support", {"core/solve"}},
    {"core/verification/known_answers/wedges", {"core/verification/known_answers/support"}},
    {"core/verification/known_answers/blocks", {"core/verification/known_answers/support"}},
    {"core/verification/known_answers/continuum", {"core/verification/known_answers/support"}},
    {"core/verification/known_answers",
     {"core/verification/known_answers/wedges", "core/verification/known_answers/blocks",
      "core/verification/known_answers/continuum"}},
    {"core/verification/hard_cases", {"core/verification/known_answers/support"}},
    {"core/verification/hard_cases/classic",
     {"core/verification/hard_cases", "core/verification/known_answers/blocks"}},
    {"core/verification/hard_cases/scenes", {"core/verification/hard_cases/classic", "core/geometry", "core/io"}},
    {"core/verification/random", {"core/verification/hard_cases/scenes"}},
    {"core/verification", {"core/verification/known_answers", "core/verification/random", "core/run", "core/io"}},
    {"core/study/runs", {"core/io"}},
    {"core/study/accuracy", {"core/study/runs", "core/run", "core/geometry"}},
    {"core/study/cases", {"core/study/runs", "core/run", "core/geometry", "core/measures"}},
    {"core/study/forecast", {"core/study/accuracy"}},
    {"ui/render/paint", {"core/base"}},
    {"ui/render/gl", {"ui/render/paint"}},
    {"ui/render/fields", {"ui/render/gl", "core/fields"}},
    {"ui/render/scene", {"ui/render/fields", "core/measures"}},
    {"ui/render/charts", {"ui/render/gl", "core/measures"}},
    {"ui/render/stereonet", {"ui/render/charts", "core/orientation"}},
    {"ui/render/views", {"ui/render/scene", "core/io"}},
    {"ui/render/film", {"ui/render/scene"}},
    {"ui/report", {"ui/render/scene", "ui/render/stereonet", "core/export", "core/io"}},
    {"ui/document", {"core/io"}},
    {"ui/jobs", {"core/study/forecast", "core/verification"}},
    {"ui/session", {"ui/document", "ui/jobs", "ui/render/views", "core/removability", "core/measures"}},
    {"ui/widgets/kit", {"core/model", "ui/render/paint"}},
    {"ui/widgets/view", {"ui/widgets/kit", "ui/session", "ui/render/views"}},
    {"ui/widgets/project", {"ui/widgets/kit", "ui/session"}},
    {"ui/widgets/begin", {"ui/widgets/kit", "ui/session", "core/templates"}},
    {"ui/widgets/study", {"ui/widgets/kit", "ui/session", "ui/render/charts"}},
    {"ui/widgets/run", {"ui/widgets/study"}},
    {"ui/widgets/results", {"ui/widgets/view", "ui/widgets/run", "ui/render/film", "ui/report"}},
    {"ui/widgets/forms", {"ui/widgets/kit", "ui/session"}},
    {"ui/widgets/geometry", {"ui/widgets/view", "ui/widgets/forms"}},
    {"ui/widgets/blocks", {"ui/widgets/kit", "ui/session"}},
    {"ui/widgets/setup", {"ui/widgets/project", "ui/widgets/forms", "ui/widgets/blocks"}},
    {"ui/widgets/actions", {"ui/widgets/kit", "ui/session"}},
    {"ui/widgets/orientation", {"ui/widgets/kit", "ui/session", "ui/render/stereonet"}},
    {"ui/widgets/joints", {"ui/widgets/view"}},
    {"ui/widgets/verification", {"ui/widgets/kit", "ui/jobs"}},
    {"ui/widgets/window",
     {"ui/widgets/begin", "ui/widgets/geometry", "ui/widgets/project", "ui/widgets/setup", "ui/widgets/actions",
      "ui/widgets/results", "ui/widgets/orientation", "ui/widgets/joints", "ui/widgets/verification"}},
    {"app/version", {}},
    {"app/cli/text",
     {"core/study/forecast", "core/study/cases", "core/verification", "core/orientation", "core/measures",
      "ui/render/charts"}},
    {"app/cli",
     {"app/version", "app/cli/text", "core/templates", "core/removability", "ui/render/film", "ui/render/views",
      "ui/report"}},
    {"app/cli/pictures", {"app/cli"}},
    {"app/cli/values", {"app/cli"}},
    {"app/cli/studies", {"app/cli"}},
    {"app/window", {"app/version", "ui/widgets/window"}},
};

/// A library's headers and the only files that may include them.
struct Fence {
  std::string library;
  std::regex header;
  std::regex inside;
};

const std::vector<Fence> fences = {
    {"Qt", std::regex("Qt?[A-Z]\\w*(/.*)?|ui_.*\\.h"),
     std::regex("(ui/(document|jobs|session|widgets)|app/window)/.*")},
    {"VTK", std::regex("vtk.*"),
     std::regex("ui/render/.*|ui/widgets/view/(\\w*viewport\\w*|render_surface)\\.(hpp|cpp)")},
    {"OpenGL", std::regex("(GL|EGL|GLES[23]|KHR)/.*"), std::regex("ui/render/.*\\.cpp")},
    {"FFmpeg", std::regex("lib(av|sw)\\w+/.*"), std::regex("ui/render/film/mp4_encoder\\.cpp")},
    {"giflib", std::regex("gif_lib\\.h"), std::regex("ui/render/.*\\.cpp")},
    {"libpng", std::regex("png\\.h"), std::regex("ui/render/.*\\.cpp")},
    {"Cairo and Pango", std::regex("(cairo|pango).*"), std::regex("ui/(render/paint|report)/.*\\.cpp")},
    {"gmsh", std::regex("gmsh.*\\.h(_cwrap)?"), std::regex("core/geometry/mesher/.*\\.cpp")},
    {"CGAL", std::regex("CGAL/.*"), std::regex("core/geometry/mesher/.*\\.cpp")},
    {"GDAL", std::regex("(gdal|ogr|cpl)\\w*\\.h"), std::regex("core/geometry/mesher/.*\\.cpp")},
    {"SuiteSparse", std::regex("(suitesparse/)?(cholmod|umfpack|SuiteSparse_config|Eigen/CholmodSupport).*"),
     std::regex("core/linear/(cholesky|sparse_lu)\\.cpp")},
    {"OpenBLAS", std::regex("cblas.*\\.h|lapacke?\\.h"), std::regex("core/linear/(cholesky|sparse_lu)\\.cpp")},
    {"oneTBB", std::regex("(oneapi/)?tbb/.*"), std::regex("core/base/parallel\\.cpp")},
    {"HDF5", std::regex("hdf5\\.h|H5\\w+\\.h"), std::regex("core/results/.*")},
    {"valijson", std::regex("valijson/.*"), std::regex("core/io/.*\\.cpp")},
    {"CLI11", std::regex("CLI/.*"), std::regex("app/.*")},
};

/// What folders show each other of core needs the standard library and Eigen only.
const std::regex standard_or_eigen("[a-z_0-9]+|Eigen/\\w+");

constexpr int longest_file = 500;  // lines
constexpr int most_units = 25;     // in a folder
constexpr int most_users = 15;     // files of other top folders that include a header

/// The folder a header "folder/room/file.hpp" belongs to; empty when it is none of ours. The command line, which is
/// included by nobody else, leaves its own name out.
std::string folder_of_header(const std::string& name) {
  const std::string folder = folder_of(name);
  for (const std::string part : {"core/", "ui/", "app/", "app/cli/"})
    if (arrows.contains(part + folder)) return part + folder;
  return {};
}

/// The path of a header "folder/room/file.hpp" of ours; empty when it is none.
std::string path_of_header(const std::string& name) {
  const std::string folder = folder_of_header(name);
  return folder.empty() ? folder : folder + name.substr(name.rfind('/'));
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

/// Folders of more units than a reader takes in; a header with its source is one.
std::vector<std::string> crowded_folders(const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> units;
  for (const SourceFile& file : files) units[folder_of(file.path)].insert(file.path.substr(0, file.path.rfind('.')));
  std::vector<std::string> crowded;
  for (const auto& [folder, names] : units)
    if (names.size() > most_units) crowded.push_back(folder + " has " + std::to_string(names.size()) + " units");
  return crowded;
}

/// core/solve of core/solve/dynamics/sleep.hpp.
std::string top_folder_of(const std::string& path) { return path.substr(0, path.find('/', path.find('/') + 1)); }

/// Headers that too many files of other top folders include; base and model are there for all.
std::vector<std::string> halls(const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> users;
  for (const SourceFile& file : files)
    for (const std::string& name : includes_of(file, '"'))
      if (const std::string path = path_of_header(name);
          !path.empty() && top_folder_of(path) != top_folder_of(file.path))
        users[path].insert(file.path);
  std::vector<std::string> crowded;
  for (const auto& [path, who] : users)
    if (who.size() > most_users && !path.starts_with("core/base/") && !path.starts_with("core/model/"))
      crowded.push_back(path + " is included by " + std::to_string(who.size()) + " files of other folders");
  return crowded;
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
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      const std::string folder = folder_of(fs::relative(entry.path(), root).generic_string());
      EXPECT_TRUE(arrows.contains(folder)) << folder;
    }
}

TEST(Headers, AreIncludedByFewFilesOfOtherFolders) { EXPECT_THAT(halls(source_tree()), IsEmpty()); }

TEST(Headers, ThatMoreThan15FilesOfOtherFoldersIncludeAreFound) {
  std::vector<SourceFile> files{{"core/mesh/block.hpp", ""}};
  for (int i = 0; i < most_users; ++i)
    files.push_back({"core/solve/user" + std::to_string(i) + ".cpp", "#include \"mesh/block.hpp\"\n"});
  files.push_back({"core/mesh/surface.cpp", "#include \"mesh/block.hpp\"\n"});
  EXPECT_THAT(halls(files), IsEmpty());
  files.push_back({"core/solve/dynamics/sleep.cpp", "#include \"mesh/block.hpp\"\n"});
  EXPECT_THAT(halls(files), ElementsAre("core/mesh/block.hpp is included by 16 files of other folders"));
}

TEST(Folders, HoldFewUnits) { EXPECT_THAT(crowded_folders(source_tree()), IsEmpty()); }

TEST(Folders, OfMoreThan25UnitsAreFound) {
  std::vector<SourceFile> files;
  for (int i = 0; i < most_units; ++i)
    for (const char* kind : {".hpp", ".cpp"}) files.push_back({"core/mesh/unit" + std::to_string(i) + kind, ""});
  EXPECT_THAT(crowded_folders(files), IsEmpty());
  files.push_back({"core/mesh/straw.cpp", ""});
  EXPECT_THAT(crowded_folders(files), ElementsAre("core/mesh has 26 units"));
}

// The checks above mean something only if they can fail.
TEST(Includes, AnArrowThatRunsUpIsFound) {
  EXPECT_THAT(faults({"core/base/error.hpp", "#pragma once\n#include \"model/project.hpp\"\n"}),
              ElementsAre("core/base/error.hpp may not include model/project.hpp"));
  EXPECT_THAT(faults({"core/results/frame.cpp", "  #  include \"run/run.hpp\"\n"}), SizeIs(1));
  EXPECT_THAT(faults({"ui/render/scene/scene.cpp", "#include \"run/run.hpp\"\n"}), SizeIs(1));
  EXPECT_THAT(faults({"core/run/run.cpp", "#include \"base/units.hpp\"\n#include \"results/frame.hpp\"\n"}), IsEmpty());
}

TEST(Includes, ALibraryOutsideItsFenceIsFound) {
  EXPECT_THAT(faults({"core/run/run.cpp", "#include <QString>\n"}),
              ElementsAre("core/run/run.cpp may not include QString: Qt has its own place"));
  EXPECT_THAT(faults({"ui/render/scene/scene.cpp", "#include <QtCore/QObject>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"ui/widgets/view/timeline.cpp", "#include <vtkActor.h>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"ui/widgets/view/gl_viewport.cpp", "#include <QMouseEvent>\n#include <vtkActor.h>\n"}),
              IsEmpty());
  EXPECT_THAT(faults({"core/linear/sparse_pattern.cpp", "#include <cholmod.h>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"core/linear/cholesky.cpp", "#include <cholmod.h>\n"}), IsEmpty());
  EXPECT_THAT(faults({"core/mesh/quality.cpp", "#include <gmsh.h>\n"}), SizeIs(1));
  EXPECT_THAT(faults({"core/geometry/block_builder.cpp", "#include <CGAL/Surface_mesh.h>\n#include <gdal.h>\n"}),
              SizeIs(2));
  EXPECT_THAT(faults({"app/cli/main.cpp", "#include <hdf5.h>\n"}), SizeIs(1));
}

TEST(Includes, AHeaderThatShowsOthersMoreThanStdAndEigenIsFound) {
  const SourceFile wrapper{"core/results/hdf5.hpp", "#include <hdf5.h>\n"};
  const SourceFile writer{"core/results/result_writer.cpp", "#include \"results/hdf5.hpp\"\n"};
  const SourceFile folder{"core/results/result_folder.hpp", "#include <string>\n#include <Eigen/Core>\n"};
  const SourceFile leaking{"core/results/result_folder.hpp", "#include \"results/hdf5.hpp\"\n"};
  const SourceFile user{"core/run/run.cpp", "#include \"results/result_folder.hpp\"\n"};
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
