// Solids are moved, turned, scaled, copied and combined in the window, and come from every kind of text file.
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <numbers>

#include "driven_window.hpp"
#include "geometry/solid_surface.hpp"
#include "listed_runs.hpp"
#include "widgets/geometry/import_dialog.hpp"
#include "widgets/geometry/measure_card.hpp"
#include "widgets/geometry/move_dialog.hpp"
#include "widgets/kit/number_field.hpp"

namespace talus {
namespace {

/// Two boxes of 4 × 2 × 2 m that have 2 × 2 × 2 m in common.
const char* const boxes = R"({"talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.2}},
    "solids": [{"name": "west", "box": {"min": [0, 0, 0], "max": [4, 2, 2]}, "material": "rock"},
               {"name": "east", "box": {"min": [2, 0, 0], "max": [6, 2, 2]}, "material": "rock"}], "stages": []})";

class SolidChanges : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    window->open(write("boxes.talus", boxes));
    ASSERT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
  }
  const Project& project() { return session->project.document().project(); }
  QUndoStack& steps() { return session->project.document().undoStack(); }
  void trigger(const char* words) {
    for (auto* action : window->actions())
      if (action->text() == QString::fromUtf8(words)) {
        EXPECT_TRUE(action->isEnabled()) << action->toolTip().toStdString();
        action->trigger();
        return rest(30);
      }
    ADD_FAILURE() << "no command says " << words;
  }
  MoveDialog* asked(const char* words, const std::vector<int>& solids) {
    session->project.selection().selectSolids(solids);
    trigger(words);
    auto* dialog = window->findChild<MoveDialog*>();
    EXPECT_NE(dialog, nullptr) << words;
    return dialog;
  }
  static NumberField* field(const QWidget& among, const char* name) {
    for (auto* one : among.findChildren<NumberField*>())
      if (one->accessibleName() == QString::fromUtf8(name)) return one;
    return nullptr;
  }
  static void type(const QWidget& among, const char* name, const char* number) {
    auto* entry = field(among, name);
    ASSERT_NE(entry, nullptr) << name;
    entry->setFocus();
    entry->selectAll();
    QTest::keyClicks(entry, QString::fromUtf8(number));
    QTest::keyClick(entry, Qt::Key_Return);
  }
  void apply(MoveDialog* dialog) {
    auto* button = dialog->findChild<QPushButton*>(QStringLiteral("apply"));
    ASSERT_TRUE(button->isEnabled()) << dialog->findChild<QLabel*>(QStringLiteral("refusal"))->text().toStdString();
    click(*button);
    ASSERT_TRUE(wait([&] { return !window->findChild<MoveDialog*>(); }));
  }
  /// As they are seen, once they are made.
  const std::vector<SolidSurface>& surfaces() {
    rest(50);
    EXPECT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
    return *session->surfaces.current();
  }
};

TEST_F(SolidChanges, AreMovedByWhatIsTypedAndSeenBeforeTheyAre) {
  const Project before = project();
  auto* dialog = asked("Move solids…", {0, 1});
  ASSERT_NE(dialog, nullptr);
  type(*dialog, "east, x", "10");
  type(*dialog, "up, z", "50 cm");
  ASSERT_TRUE(wait([&] { return !session->surfaces.isBusy() && session->surfaces.current()->at(1).max.x() > 15; }))
      << "the view shows it while it is asked for";
  EXPECT_EQ(project(), before);
  apply(dialog);
  EXPECT_LT((surfaces().at(0).min - Vec3(10, 0, 0.5)).norm(), 1e-9);
  EXPECT_LT((surfaces().at(1).max - Vec3(16, 2, 2.5)).norm(), 1e-9);
  EXPECT_EQ(steps().undoText(), QStringLiteral("move 2 solids"));
  steps().undo();
  EXPECT_EQ(project(), before) << "one step";
}

TEST_F(SolidChanges, AreTurnedAboutAnAxisThroughTheirMiddle) {
  auto* dialog = asked("Turn solids…", {0});
  ASSERT_NE(dialog, nullptr);
  type(*dialog, "Angle", "90");
  apply(dialog);
  EXPECT_LT((surfaces().at(0).min - Vec3(1, -1, 0)).norm(), 1e-9) << "4 m from south to north now";
  EXPECT_LT((surfaces().at(0).max - Vec3(3, 3, 2)).norm(), 1e-9);
}

TEST_F(SolidChanges, AreScaledAndAFactorOfNothingIsRefused) {
  auto* dialog = asked("Scale solids…", {1});
  ASSERT_NE(dialog, nullptr);
  type(*dialog, "Factor", "0");
  EXPECT_FALSE(dialog->findChild<QPushButton*>(QStringLiteral("apply"))->isEnabled());
  EXPECT_FALSE(dialog->findChild<QLabel*>(QStringLiteral("refusal"))->text().isEmpty());
  type(*dialog, "Factor", "2");
  apply(dialog);
  EXPECT_NEAR(surfaces().at(1).volume, 8 * 16, 1e-9);
  EXPECT_LT(((surfaces().at(1).min + surfaces().at(1).max) / 2 - Vec3(4, 1, 1)).norm(), 1e-9) << "about its middle";
}

TEST_F(SolidChanges, AreCopiedAStepFurtherEachTime) {
  auto* dialog = asked("Copy solids…", {0});
  ASSERT_NE(dialog, nullptr);
  type(*dialog, "north, y", "5");
  type(*dialog, "Copies", "3");
  apply(dialog);
  ASSERT_EQ(project().solids.size(), 5U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(surfaces().at(i).min.y(), 5.0 * static_cast<double>(i), 1e-9);
  EXPECT_EQ(project().solids[4].name, "east");
}

TEST_F(SolidChanges, AreUnitedIntersectedAndSubtracted) {
  for (const auto& [words, volume] :
       {std::pair("Unite solids", 24.0), {"Intersect solids", 8.0}, {"Subtract the last selected", 8.0}}) {
    session->project.selection().selectSolids({0, 1});
    trigger(words);
    ASSERT_EQ(project().solids.size(), 3U) << words;
    ASSERT_TRUE(wait([&] { return surfaces().size() == 1U; })) << words;
    EXPECT_NEAR(surfaces()[0].volume, volume, 1e-9) << words;
    steps().undo();
    EXPECT_EQ(surfaces().size(), 2U) << words;
  }
}

TEST_F(SolidChanges, ANewShapeStandsBesideWhatIsThereAndHasItsForm) {
  for (const char* words : {"New box", "New polyhedron", "New tunnel"}) {
    const std::size_t before = project().solids.size();
    trigger(words);
    ASSERT_EQ(project().solids.size(), before + 1) << words;
    EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::solid, static_cast<int>(before)})) << words;
    ASSERT_EQ(surfaces().size(), before + 1) << words;
    EXPECT_GT(surfaces().back().volume, 0) << words;
  }
}

TEST_F(SolidChanges, TheAngleOfThreePlacesAndTheirPlaneAreMeasured) {
  trigger("Measure");
  auto* card = window->findChild<MeasureCard*>();
  ASSERT_TRUE(card && card->isVisible());
  auto* what = card->findChild<QComboBox*>();
  what->setCurrentIndex(2);
  emit what->activated(2);
  for (const Vec3& place : {Vec3(4, 0, 2), Vec3(0, 0, 2), Vec3(0, 2, 0)})
    session->picking.take({.solid = 0, .point = place});
  rest(30);
  ASSERT_GE(card->rows().size(), 3U);
  EXPECT_EQ(card->rows()[0].value, QStringLiteral("90.0°"));
  EXPECT_EQ(card->rows()[1].value, QStringLiteral("45/000")) << "down to the north";
  EXPECT_EQ(card->rows()[2].value.left(4), QStringLiteral("5.65")) << "half of 4 × 2√2 m²";
}

/// A box of 1 × 2 × 3 m, its low corner in the origin, with six sides as each format has them.
struct TextFile {
  const char *name, *words;
};
const TextFile text_files[] = {
    {"box.obj",
     "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\nv 1 0 3\nv 1 2 3\nv 0 2 3\n"
     "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"},
    {"box.ply",
     "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
     "element face 6\nproperty list uchar int vertex_indices\nend_header\n"
     "0 0 0\n1 0 0\n1 2 0\n0 2 0\n0 0 3\n1 0 3\n1 2 3\n0 2 3\n"
     "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"},
    {"box.msh",
     "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 2 0\n4 0 2 0\n5 0 0 3\n6 1 0 3\n"
     "7 1 2 3\n8 0 2 3\n$EndNodes\n$Elements\n12\n1 2 2 1 1 4 3 2\n2 2 2 1 1 4 2 1\n3 2 2 1 1 5 6 7\n"
     "4 2 2 1 1 5 7 8\n5 2 2 1 1 1 2 6\n6 2 2 1 1 1 6 5\n7 2 2 1 1 2 3 7\n8 2 2 1 1 2 7 6\n"
     "9 2 2 1 1 3 4 8\n10 2 2 1 1 3 8 7\n11 2 2 1 1 4 1 5\n12 2 2 1 1 4 5 8\n$EndElements\n"}};

TEST_F(SolidChanges, ComeFromObjPlyAndMshFilesThatAreDropped) {
  for (const TextFile& file : text_files) {
    drop(write(file.name, file.words));
    auto* dialog = window->findChild<ImportDialog*>();
    ASSERT_NE(dialog, nullptr) << file.name;
    ASSERT_TRUE(wait([&] { return !dialog->isReading(); }));
    ASSERT_TRUE(dialog->reading().surface) << file.name;
    EXPECT_NEAR(dialog->reading().surface->volume, 6, 1e-9) << file.name;
    click(*dialog->findChild<QPushButton*>(QStringLiteral("import")));
    ASSERT_TRUE(wait([&] { return !window->findChild<ImportDialog*>(); })) << file.name;
  }
  EXPECT_EQ(project().solids.size(), 5U);
}

TEST_F(SolidChanges, TerrainComesFromPointsThatAreDropped) {
  std::string points;
  for (int x = 0; x <= 4; ++x)
    for (int y = 0; y <= 3; ++y)
      points += std::to_string(10 * x) + " " + std::to_string(10 * y) + " " + std::to_string(100 + x) + "\n";
  drop(write("ground.xyz", points));
  auto* dialog = window->findChild<ImportDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(wait([&] { return !dialog->isReading(); }));
  click(*dialog->findChild<QPushButton*>(QStringLiteral("import")));
  ASSERT_TRUE(wait([&] { return !window->findChild<ImportDialog*>(); }));
  const auto* ground = std::get_if<TerrainShape>(&project().solids.at(2).shape);
  ASSERT_NE(ground, nullptr);
  EXPECT_NEAR(surfaces().at(2).volume, 40 * 30 * (102 - ground->base), 1e-6);
}

}  // namespace
}  // namespace talus
