#include "document/item_at.hpp"

#include <gtest/gtest.h>

#include "model/project.hpp"

namespace talus {
namespace {

Project example() {
  Project project;
  project.materials.resize(2);
  project.materials[1].name = "marl/clay";
  project.cuts.resize(3);
  project.stages.resize(1);
  project.stages[0].name = "slide";
  return project;
}

TEST(ItemAt, APlaceBelongsToTheThingThatHoldsIt) {
  const Project project = example();
  EXPECT_EQ(itemAt(project, QStringLiteral("/materials/marl~1clay/density")), (Item{Item::Kind::material, 1}));
  EXPECT_EQ(itemAt(project, QStringLiteral("/cuts/2")), (Item{Item::Kind::cut, 2}));
  EXPECT_EQ(itemAt(project, QStringLiteral("/stages/0/joints/J1")), (Item{Item::Kind::stage, 0}));
}

TEST(ItemAt, WhatIsNotThereOrBelongsToTheWholeIsNone) {
  const Project project = example();
  for (const char* place : {"/", "/gravity", "/gravity/2", "/cuts/3", "/cuts/-1", "/materials/rock", "/solver/contact"})
    EXPECT_EQ(itemAt(project, QLatin1String(place)), Item{}) << place;
}

TEST(PlaceWords, SayTheThingAndItsField) {
  const Project project = example();
  EXPECT_EQ(placeWords(project, QStringLiteral("/materials/marl~1clay/density")).toStdString(),
            "material marl/clay, density ρ");
  EXPECT_EQ(placeWords(project, QStringLiteral("/stages/0/time_step")).toStdString(), "stage slide, time step");
  EXPECT_EQ(placeWords(project, QStringLiteral("/cuts/2/dip")).toStdString(), "cut 3, dip");
  EXPECT_EQ(placeWords(project, QStringLiteral("/materials/marl~1clay/young")).toStdString(),
            "material marl/clay, Young E");
  EXPECT_EQ(placeWords(project, QStringLiteral("/constraints/1/at/2")).toStdString(), "support 2, at, z");
  EXPECT_EQ(placeWords(project, QStringLiteral("/stages/0/joints/J1/cohesion")).toStdString(),
            "stage slide, joint strength J1, cohesion c");
  EXPECT_EQ(placeWords(project, QStringLiteral("/solver/open_close_limit")).toStdString(), "solver, open–close limit");
  EXPECT_EQ(placeWords(project, QStringLiteral("the file")).toStdString(), "the file");
  EXPECT_EQ(placeWords(project, QStringLiteral("/solids")).toStdString(), "solids");
  EXPECT_EQ(placeWords(project, QStringLiteral("/")).toStdString(), "project");
}

}  // namespace
}  // namespace talus
