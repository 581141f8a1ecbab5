#include "render/views/view_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace talus {
namespace {

SavedView full_view() {
  SavedView view;
  view.width = 1234;
  view.height = 567;
  view.time = 12.3456789012345678;
  view.settings.theme = Theme::dark;
  view.settings.field = field_named("joint.slip");
  view.settings.range = ValueRange{-0.1, 1.0 / 3};
  view.settings.only = ValueRange{0.25, 0.75};
  view.settings.arrows = Arrows::contact_force;
  view.settings.trails = Trails::selected;
  view.settings.turning_axes = true;
  view.settings.probed_line = std::array{Vec3(1, 2, 3), Vec3(4, 5, 6.5)};
  view.settings.edges = Edges::mesh;
  view.settings.deformation_scale = 10;
  view.settings.explosion = 0.6;
  view.settings.section = SectionPlane{Vec3(1.1, 2, 3), Vec3(0, 0.6, 0.8)};
  view.settings.rock_opacity = 0.5;
  view.settings.block_colours = std::make_shared<const BlockColours>(
      BlockColours{"Material", {rgb(0x77aadd), rgb(0x0012ff)}, {{rgb(0x77aadd), "rock"}}});
  view.settings.contacts = true;
  view.settings.troubles = view.settings.actions = view.settings.legend = view.settings.time_stamp = false;
  view.settings.triad = view.settings.scale_bar = false;
  view.settings.title = "A \"slope\" – north";
  view.settings.text_height = 11.7;
  view.camera.position = Vec3(1e5 + 0.1, -2e5 / 3, 300);
  view.camera.focal_point = Vec3(1, 2, 3);
  view.camera.view_up = Vec3(0, 0.1, 0.995);
  view.camera.view_angle = 30;
  view.camera.parallel_scale = 77.7;
  view.camera.parallel = view.settings.parallel_projection = true;
  view.hidden = {"B2"};
  view.selected = {"B1"};
  view.covered = {{1, 2, 3.5, 4}};
  view.beside = {{"../wet/slope.results", true}, {"dry.results", false}};
  return view;
}

TEST(ViewFile, KeepsAllOfAViewToTheBit) {
  const SavedView written = full_view(), read = view_of_text(view_text(written));
  EXPECT_EQ(view_text(read), view_text(written));
  EXPECT_EQ(read.width, 1234);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.camera.position, written.camera.position);
  EXPECT_TRUE(read.camera.parallel);
  EXPECT_TRUE(read.settings.parallel_projection);
  EXPECT_EQ(read.settings.field->name, "joint.slip");
  EXPECT_EQ(read.settings.range, written.settings.range);
  EXPECT_EQ(read.settings.edges, Edges::mesh);
  EXPECT_EQ(read.settings.only, written.settings.only);
  EXPECT_EQ(read.settings.arrows, Arrows::contact_force);
  EXPECT_EQ(read.settings.trails, Trails::selected);
  EXPECT_TRUE(read.settings.turning_axes);
  EXPECT_EQ(read.settings.probed_line, written.settings.probed_line);
  EXPECT_EQ(read.settings.section, written.settings.section);
  EXPECT_EQ(read.settings.block_colours->colours, written.settings.block_colours->colours);
  EXPECT_EQ(read.settings.block_colours->key[0].meaning, "rock");
  EXPECT_FALSE(read.settings.scale_bar);
  EXPECT_TRUE(read.settings.contacts);
  EXPECT_EQ(read.hidden, written.hidden);
  EXPECT_EQ(read.covered, written.covered);
  ASSERT_EQ(read.beside.size(), 2u);
  EXPECT_EQ(read.beside[0].results, "../wet/slope.results");
  EXPECT_TRUE(read.beside[0].over);
  EXPECT_FALSE(read.beside[1].over);
}

TEST(ViewFile, NamesWhatItComparesFromItsOwnFolderOn) {
  const std::filesystem::path root = std::filesystem::temp_directory_path() / "talus_view_file_test";
  std::filesystem::remove_all(root);
  std::filesystem::create_directories(root / "here/views");
  SavedView view = full_view();
  view.beside = {{root / "here/dry.results"}, {root / "wet.results"}};
  save_view(view, root / "here/views/a.json");
  std::filesystem::rename(root / "here", root / "there");  // as a whole
  const SavedView read = read_view(root / "there/views/a.json");
  EXPECT_EQ(read.beside[0].results, root / "there/dry.results");
  EXPECT_EQ(read.beside[1].results, root / "wet.results");
  std::filesystem::remove_all(root);
}

std::string with(const std::string& line) {
  return "{ // by hand\n \"talus_view\": 1, \"size\": [640, 480],\n \"camera\": {\"position\": [0, -9, 2], "
         "\"focal_point\": [0, 0, 0], \"view_up\": [0, 0, 1]}" +
         (line.empty() ? line : ",\n " + line) + "\n}";
}

TEST(ViewFile, WhatIsLeftOutIsAsScenesAre) {
  const SavedView view = view_of_text(with(""));
  const SceneSettings usual;
  EXPECT_EQ(view.settings.edges, usual.edges);
  EXPECT_FALSE(view.settings.field);
  EXPECT_FALSE(view.time);
  EXPECT_TRUE(view.settings.legend);
}

std::string complaint(const std::string& text) {
  try {
    view_of_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ViewFile, WhatIsWrongIsSaidWithPlaceAndRemedy) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(complaint("{"), HasSubstr("line 1"));
  EXPECT_THAT(complaint("{\"talus_view\": 1}"), HasSubstr("'size' is missing"));
  EXPECT_THAT(complaint(with("\"feild\": \"velocity\"")),
              AllOf(HasSubstr("line 4"), HasSubstr("'feild' is not known"), HasSubstr("field")));
  EXPECT_THAT(complaint(with("\"field\": \"speed\"")), AllOf(HasSubstr("no such field"), HasSubstr("velocity.x")));
  EXPECT_THAT(complaint(with("\"edges\": \"all\"")), AllOf(HasSubstr("line 4, /edges"), HasSubstr("mesh")));
  EXPECT_THAT(complaint(with("\"rock_opacity\": 2")), AllOf(HasSubstr("/rock_opacity"), HasSubstr("at most 1")));
  EXPECT_THAT(complaint(with("\"range\": [2, 1]")), AllOf(HasSubstr("range"), HasSubstr("lower one first")));
  EXPECT_THAT(complaint(with("\"range\": [2]")), HasSubstr("must have 2 entries"));
  EXPECT_THAT(complaint(with("\"section\": {\"point\": [0, 0, 0], \"towards\": [0, 0, 0]}")), HasSubstr("direction"));
  EXPECT_THAT(complaint(with("\"block_colours\": {\"title\": \"\", \"colours\": [\"red\"], \"key\": []}")),
              AllOf(HasSubstr("'red' is no colour"), HasSubstr("#77aadd")));
  EXPECT_THAT(complaint(with("\"compared\": [{\"over\": true}]")),
              AllOf(HasSubstr("/compared/0"), HasSubstr("'results' is missing")));
  EXPECT_THAT(complaint("{\"talus_view\": 2, \"size\": [640, 480], \"camera\": {}}"), HasSubstr("talus_view"));
  std::string nowhere = with("");
  nowhere.replace(nowhere.find("[0, -9, 2]"), 10, "[0, 0, 0]");
  EXPECT_THAT(complaint(nowhere), HasSubstr("looks nowhere"));
}

TEST(ViewFile, AFileThatIsNotThereIsNamed) {
  try {
    read_view("/nowhere/slope.view.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.place(), testing::StartsWith("/nowhere/slope.view.json: "));
  }
  EXPECT_THROW(save_view(full_view(), "/nowhere/slope.view.json"), InputError);
}

TEST(ViewFile, NamesOfBlocksThatAreNotThereAreRefused) {
  BlockSystem system;
  system.blocks.resize(3);
  for (int i = 0; i < 3; ++i) system.blocks[static_cast<std::size_t>(i)].name = "B" + std::to_string(i);
  EXPECT_THAT(blocks_named(system, {"B2", "B0"}), testing::ElementsAre(0, 2));
  EXPECT_THROW(blocks_named(system, {"B3"}), InputError);
}

}  // namespace
}  // namespace talus
