#include "document/edits.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.hpp"
#include "document/item_place.hpp"
#include "document/names.hpp"
#include "document/things.hpp"
#include "io/project_file.hpp"
#include "unit/io/sample_project.hpp"

namespace talus {
namespace {

using schema::Json;
using schema::Place;

Json full() { return Json::parse(test::full_project, nullptr, true, true); }

TEST(Schema, HasATitleForEveryFieldThatCanBeSet) {
  const std::function<void(const Json&, const std::string&)> walk = [&](const Json& rule, const std::string& path) {
    for (const auto& [key, part] : rule.items()) {
      const Json properties = key == "properties" ? part : Json::object();
      for (const auto& [name, property] : properties.items())
        EXPECT_FALSE(schema::resolved(property).value("title", std::string()).empty()) << path << "/" << name;
      if (part.is_structured()) walk(part, path + "/" + key);
    }
  };
  walk(schema::root(), {});
}

TEST(Schema, SaysOfEveryOptionalFieldWhatItMeansToLeaveItOut) {
  const std::function<void(const Json&, const std::string&)> walk = [&](const Json& rule, const std::string& path) {
    if (rule.is_object() && rule.contains("properties") && path.starts_with("/definitions"))
      for (const auto& [key, ignored] : rule.at("properties").items()) {
        const Json field = schema::memberRule(rule, key);
        if (!schema::isOptional(rule, key)) continue;
        const bool isText = schema::kindOf(field) == schema::Kind::text;
        EXPECT_TRUE(isText || field.contains("default") || field.contains("absent")) << path << "/" << key;
      }
    for (const auto& [key, part] : rule.items())
      if (part.is_structured()) walk(part, path + "/" + key);
  };
  walk(schema::root(), {});
}

TEST(Schema, DefaultsAreThoseOfTheModel) {
  const auto usual = [](const char* place) { return schema::ruleOf(Place(place)).at("default"); };
  const Stage stage;
  const SolverSettings solver;
  EXPECT_EQ(usual("/stages/0/equilibrium_tolerance"), stage.equilibrium_tolerance);
  EXPECT_EQ(usual("/solver/spectral_radius"), solver.spectral_radius);
  EXPECT_EQ(usual("/solver/contact_stiffness"), solver.contact_stiffness);
  EXPECT_EQ(usual("/solver/open_close_limit"), solver.open_close_limit);
  EXPECT_EQ(usual("/solver/adaptive/error_limit"), solver.adaptive.error_limit);
  EXPECT_EQ(usual("/solver/adaptive/displacement_limit"), solver.adaptive.displacement_limit);
  EXPECT_EQ(usual("/solver/adaptive/iterations"), solver.adaptive.iterations);
  EXPECT_EQ(usual("/solver/adaptive/shortest"), solver.adaptive.shortest);
  EXPECT_EQ(usual("/solver/integrator"), to_string(solver.integrator));
  EXPECT_EQ(usual("/solver/strain"), to_string(solver.strain));
  EXPECT_EQ(usual("/solver/contact"), to_string(solver.contact));
  EXPECT_EQ(usual("/solver/time_step_control"), to_string(solver.time_step_control));
  EXPECT_EQ(usual("/solids/0/body"), to_string(Solid{}.body));
  EXPECT_EQ(usual("/materials/rock/law"), to_string(Material{}.law));
  EXPECT_EQ(usual("/output/every"), Project{}.output.every);
  EXPECT_EQ(usual("/gravity").at(2), Project{}.gravity.z());
}

TEST(Schema, ReadySettingsAreSettings) {
  for (const auto& [name, values] : schema::ruleOf(Place("/solver")).at("presets").items()) {
    Json project = Json::parse(test::small_project);
    project["solver"] = values;
    EXPECT_NO_THROW(parse_project(project.dump())) << name;
  }
}

TEST(Schema, APresetSetsTheDefaultsThatTheProgramTakes) {
  Json project = Json::parse(test::small_project);
  project["solver"] = {{"preset", "paper"}};
  const Json rule = schema::ruleOf(Place("/solver"));
  Json whole = project;
  int set = 0;
  for (const auto& [key, value] : rule.at("properties").at("preset").at("sets").at("paper").items()) {
    Json member = schema::memberRule(rule, key);
    schema::setDefault(member, key, rule, project["solver"]);
    EXPECT_EQ(member.at("default"), value) << key;
    whole["solver"][key] = value;
    ++set;
  }
  EXPECT_EQ(set, 7);
  EXPECT_EQ(parse_project(project.dump()).solver, parse_project(whole.dump()).solver);
  EXPECT_EQ(parse_project(project.dump()).solver, settings_of(Preset::paper));
  Json member = schema::memberRule(rule, "extras");
  schema::setDefault(member, "extras", rule, Json{{"preset", "talus"}});
  EXPECT_EQ(member.at("default"), "called_for");
}

TEST(Edits, ANewThingIsOneThatAProjectMayHold) {
  for (const char* list : {"materials", "joints", "solids", "cuts", "blocks", "interfaces", "constraints", "loads",
                           "velocities", "in_situ", "stages", "monitors"}) {
    Json project = full();
    const Place place = edits::add(project, Place() / std::string(list));
    EXPECT_NO_THROW(parse_project(project.dump(), {.unfinished = true})) << list << " " << project.at(place).dump();
  }
}

TEST(Edits, WhatBelongsTogetherIsSetAndClearedTogether) {
  Json project = Json::parse(test::small_project);
  edits::set(project, Place("/cuts/0/spacing"), 2);
  EXPECT_TRUE(project["cuts"][0].contains("count"));
  edits::clear(project, Place("/cuts/0/count"));
  EXPECT_FALSE(project["cuts"][0].contains("spacing"));
  edits::setVariant(project, Place("/solids/0"), "file");
  EXPECT_FALSE(project["solids"][0].contains("box"));
  edits::set(project, Place("/solids/0/scale"), 0.001);
  edits::setVariant(project, Place("/solids/0"), "box");
  EXPECT_FALSE(project["solids"][0].contains("scale")) << "of a file that there is no more";
  edits::set(project, Place("/solver/adaptive/iterations"), 5);
  EXPECT_EQ(project["solver"]["adaptive"]["iterations"], 5);
}

TEST(Edits, ThingsAreCopiedAndMoved) {
  Json project = full();
  EXPECT_EQ(edits::duplicate(project, Place("/joints/J2")), Place("/joints/J2 1"));
  EXPECT_EQ(std::next(project["joints"].begin()).key(), "J2 1");
  EXPECT_EQ(edits::duplicate(project, Place("/solids/0")), Place("/solids/1"));
  EXPECT_EQ(project["solids"][1]["name"], "slope 1");
  EXPECT_EQ(edits::move(project, Place("/solids/0"), 9), Place("/solids/7"));
  EXPECT_EQ(project["solids"][7]["name"], "slope");
  edits::move(project, Place("/joints/J1"), -5);
  EXPECT_EQ(project["joints"].begin().key(), "J1");
  EXPECT_NO_THROW(parse_project(project.dump()));
}

TEST(Names, OfWhatIsRenamedFollowEverywhere) {
  Json project = full();
  names::rename(project, Place("/joints/J1"), "bedding");
  EXPECT_EQ(project["default_joint"], "bedding");
  EXPECT_EQ(project["cuts"][0]["joint"], "bedding");
  EXPECT_TRUE(project["stages"][1]["joints"].contains("bedding"));
  names::rename(project, Place("/solids/0"), "hillside");
  EXPECT_EQ(project["cuts"][0]["solids"][0], "hillside");
  EXPECT_EQ(project["in_situ"][1]["blocks"][1], "hillside.2") << "a piece of it";
  EXPECT_EQ(project["expect"][1]["quantity"], "hillside.2.velocity.magnitude");
  names::rename(project, Place("/monitors/0"), "crest");
  EXPECT_EQ(project["expect"][0]["quantity"], "crest.displacement.z");
  EXPECT_NO_THROW(parse_project(project.dump()));
}

TEST(Names, OfSeveralThingsChangeAtOnceSoThatTwoMaySwapThem) {
  Json project = {{"loads", Json::array({{{"block", "a"}}, {{"block", "b"}}, {{"block", "c"}}})},
                  {"interfaces", Json::array({{{"between", {"a", "b"}}}})}};
  names::follow(project, "blocks", {{"a", "b"}, {"b", "a"}});
  EXPECT_EQ(project["loads"][0]["block"], "b");
  EXPECT_EQ(project["loads"][1]["block"], "a");
  EXPECT_EQ(project["loads"][2]["block"], "c");
  EXPECT_EQ(project["interfaces"][0]["between"], Json::array({"b", "a"}));
}

TEST(Names, AThingIsDescribedByItsKindAndName) {
  const Json project = full();
  EXPECT_EQ(names::described(Place("/joints/J1/cohesion"), project).toStdString(), "joint J1");
  EXPECT_EQ(names::described(Place("/cuts/1"), project).toStdString(), "cut 2");
  EXPECT_EQ(names::described(Place("/stages/1/joints/J2"), project).toStdString(), "joint strength J2 of stage slide");
}

TEST(Things, ThatAreNamedByOthersAreNotDeleted) {
  Document document;
  document.show(parse_project(test::full_project));
  try {
    things::remove(document, {Item::Kind::material, 0});
    FAIL() << "deleted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(),
              "material soft rock is used by solid slope, solid hill, solid bore, solid bench, 1 more");
  }
  things::remove(document, {Item::Kind::expectation, 0});
  EXPECT_EQ(document.project().expect.size(), 1u);
  EXPECT_EQ(document.undoStack().undoText().toStdString(), "delete expected value 1");
}

TEST(Things, TheFirstJointIsThatOfContactsOnNoCut) {
  Document document;
  document.show(Project{});
  things::add(document, Item::Kind::joint);
  EXPECT_EQ(document.project().default_joint, "joint 1");
  EXPECT_EQ(document.selection().current(), (Item{Item::Kind::joint, 0}));
}

TEST(Things, HavePlacesAndPlacesHaveThings) {
  const Json project = full();
  EXPECT_EQ(placeOf({Item::Kind::joint, 1}, project), Place("/joints/J1"));
  EXPECT_EQ(itemAt(Place("/joints/J1/cohesion"), project), (Item{Item::Kind::joint, 1}));
  EXPECT_EQ(itemAt(Place("/solids/2"), project), (Item{Item::Kind::solid, 2}));
  EXPECT_EQ(itemAt(Place("/solver/contact"), project), (Item{Item::Kind::solver, 0}));
  EXPECT_EQ(itemAt(Place("/solids/9"), project), Item{});
  EXPECT_EQ(itemAt(Place("/gravity"), project), Item{});
}

}  // namespace
}  // namespace talus
