#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "source_tree.hpp"

// docs/pictures/rooms.svg shows which room is built upon which. tools/draw_rooms.py writes every arrow into it as a
// comment, "<!-- core/solve -> core/effects 12 -->", and every room as a label.
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::set<std::string> rooms_of(const std::vector<SourceFile>& files) {
  std::set<std::string> rooms;
  for (const SourceFile& file : files) rooms.insert(folder_of(file.path));
  return rooms;
}

/// "core/solve -> core/effects" for every room that includes a header of another.
std::set<std::string> arrows_of(const std::vector<SourceFile>& files) {
  const std::set<std::string> rooms = rooms_of(files);
  std::set<std::string> arrows;
  for (const SourceFile& file : files)
    for (const std::string& header : includes_of(file, '"'))
      for (const std::string part : {"core/", "ui/", "app/", "app/cli/"})
        if (const std::string room = part + folder_of(header); rooms.contains(room)) {
          if (room != folder_of(file.path)) arrows.insert(folder_of(file.path) + " -> " + room);
          break;
        }
  return arrows;
}

std::set<std::string> arrows_in(const std::string& picture) {
  const std::regex comment("<!-- (\\S+ -> \\S+) \\d+ -->");
  std::set<std::string> arrows;
  for (std::sregex_iterator match(picture.begin(), picture.end(), comment), end; match != end; ++match)
    arrows.insert((*match)[1]);
  return arrows;
}

/// What stands in one of two sets alone.
std::set<std::string> difference(const std::set<std::string>& tree, const std::set<std::string>& picture) {
  std::set<std::string> lines;
  for (const std::string& arrow : tree)
    if (!picture.contains(arrow)) lines.insert("not in the picture: " + arrow);
  for (const std::string& arrow : picture)
    if (!tree.contains(arrow)) lines.insert("no longer in the tree: " + arrow);
  return lines;
}

std::string picture() {
  std::ostringstream text;
  text << std::ifstream(std::string(TALUS_SOURCE_DIR) + "/docs/pictures/rooms.svg").rdbuf();
  return text.str();
}

TEST(Picture, OfTheRoomsHasTheArrowsOfTheTree) {
  const std::set<std::string> tree = arrows_of(source_tree());
  ASSERT_GT(tree.size(), 100U);
  EXPECT_THAT(difference(tree, arrows_in(picture())), IsEmpty()) << "run tools/draw_rooms.py";
}

TEST(Picture, OfTheRoomsNamesEveryRoom) {
  const std::string text = picture();
  for (const std::string& room : rooms_of(source_tree()))
    EXPECT_NE(text.find("<title>" + room + "</title>"), std::string::npos) << room << ": run tools/draw_rooms.py";
}

TEST(Picture, ThatIsStaleIsFound) {
  const std::vector<SourceFile> files{{"core/solve/step.cpp", "#include \"effects/effect.hpp\"\n"},
                                      {"core/effects/effect.hpp", "#include <vector>\n"}};
  EXPECT_THAT(arrows_of(files), ElementsAre("core/solve -> core/effects"));
  EXPECT_THAT(difference(arrows_of(files), arrows_in("<!-- core/solve -> core/effects 12 -->")), IsEmpty());
  EXPECT_THAT(difference(arrows_of(files), arrows_in("<!-- core/solve -> core/bodies 2 -->")),
              ElementsAre("no longer in the tree: core/solve -> core/bodies",
                          "not in the picture: core/solve -> core/effects"));
}

}  // namespace
