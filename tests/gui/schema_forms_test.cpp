#include <gmock/gmock.h>

#include <QAction>
#include <algorithm>

#include "document/item_place.hpp"
#include "driven_form.hpp"
#include "io/project_file.hpp"
#include "unit/io/sample_project.hpp"

// All that a project file can say, the window can make: the project of the readers' tests, which has every field of the
// schema, is set up in an empty window by typing, choosing, pasting and clicking alone.
namespace talus {
namespace {

using testing::IsEmpty;

std::vector<std::string> missing(const std::set<std::string>& all, const std::set<std::string>& entered) {
  std::vector<std::string> left;
  std::ranges::set_difference(all, entered, std::back_inserter(left));
  return left;
}

TEST_F(DrivenForm, EveryFieldOfTheSchemaIsSetThroughTheWindowAndTakenBack) {
  const Json target = Json::parse(test::full_project, nullptr, true, true);
  const std::string nothing = "{\"talus\": 1} // empty\n";
  window->open(write("new.talus", nothing));
  ASSERT_TRUE(session->project.document().isOpen());
  for (const char* list : {"materials", "joints", "solids", "cuts", "blocks", "merges", "interfaces", "constraints",
                           "loads", "velocities", "in_situ", "stages", "monitors", "expect"}) {
    enterThings(list, target.at(list));
    ASSERT_FALSE(HasFatalFailure());
  }
  for (const auto& [key, kind] : {std::pair{"solver", Item::Kind::solver},
                                  {"output", Item::Kind::output},
                                  {"splinters", Item::Kind::splinters},
                                  {"mesh", Item::Kind::mesh}}) {
    selectRow({kind, 0});
    // The form of a thing that the file leaves out is open all the same: its fields make it.
    for (const auto& [name, value] : target.at(key).items()) enter(Place() / std::string(key) / name, value);
    entered.insert(fieldAt(Place() / std::string(key)));
  }
  session->project.selection().clear();
  rest(10);
  for (const char* key : {"name", "gravity", "origin", "default_joint"})
    enter(Place() / std::string(key), target.at(key));

  // What a new thing has already is changed, and changed back.
  for (const auto& [at, other] : {std::pair<const char*, Json>{"/solids/0/box/min", {-1, 0, 0}},
                                  {"/solids/0/box/max", {11, 10, 10}},
                                  {"/solids/2/turn/axis", {1, 0, 1}},
                                  {"/solids/5/section/points", {{0, 0}, {20, 0}, {20, 10}}},
                                  {"/solids/6/combine/operation", "unite"},
                                  {"/cuts/5/network/box/min", {-1, 0, 0}},
                                  {"/cuts/5/network/box/max", {11, 10, 10}},
                                  {"/cuts/5/network/density", 0.25},
                                  {"/cuts/5/network/radius", 1},
                                  {"/interfaces/0/joint", "J1"},
                                  {"/loads/0/block", "wedge"},
                                  {"/monitors/0/block", "wedge"},
                                  {"/stages/0/blocks/0/name", "wedge"},
                                  {"/stages/1/joints/J1/cohesion", 1}}) {
    const Place place(at);
    session->project.selection().select(itemAt(place, project()));
    rest(10);
    enter(place, other);
    enter(place, target.at(place));
  }
  for (const char* box : {"/solids/0/box", "/cuts/5/network/box"}) entered.insert(fieldAt(Place(box)));  // by corners
  EXPECT_EQ(nlohmann::json(project()), nlohmann::json(target));
  EXPECT_THAT(missing(fieldsOf(schema::root()), entered), IsEmpty());

  const auto trigger = [&](const QKeySequence& keys) {
    for (auto* action : window->actions())
      if (action->shortcuts().contains(keys)) action->trigger();
  };
  QUndoStack& steps = session->project.document().undoStack();
  const int all = steps.count();
  EXPECT_GT(all, 150);
  for (int i = 0; i < all; ++i) {
    EXPECT_FALSE(steps.undoText().isEmpty()) << "every step has a name";
    trigger(QKeySequence::Undo);
  }
  EXPECT_EQ(session->project.document().text(), nothing) << "to the byte";
  for (int i = 0; i < all; ++i) trigger(QKeySequence(QStringLiteral("Ctrl+Y")));
  EXPECT_EQ(nlohmann::json(project()), nlohmann::json(target));
  session->project.save();
  EXPECT_EQ(read_project(session->project.document().file()), parse_project(test::full_project));
}

TEST_F(DrivenForm, AFieldThatNobodySetsIsFound) {
  const Json rule = Json::parse(R"({"properties": {"dip": {"type": "number"}, "swell": {"type": "number"}}})");
  EXPECT_THAT(missing(fieldsOf(rule), {"/properties/dip"}), testing::ElementsAre("/properties/swell"));
}

}  // namespace
}  // namespace talus
