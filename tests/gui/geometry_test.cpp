#include <gmock/gmock.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <cmath>
#include <numbers>

#include "base/progress.hpp"
#include "driven_window.hpp"
#include "example_projects.hpp"
#include "geometry/solid_surface.hpp"
#include "widgets/geometry/import_dialog.hpp"
#include "widgets/geometry/measure_card.hpp"
#include "widgets/geometry/section_editor.hpp"
#include "widgets/geometry/section_plot.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/view/solid_viewport.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class GeometryPage : public DrivenWindow {
 protected:
  const Project& project() { return session->project.document().project(); }
  QUndoStack& steps() { return session->project.document().undoStack(); }
  ImportDialog* dialog() { return window->findChild<ImportDialog*>(); }
  /// Drops a file, and waits until the dialog has read it.
  ImportDialog* importing(const fs::path& file) {
    drop(file);
    EXPECT_TRUE(dialog());
    EXPECT_TRUE(wait([&] { return dialog() && !dialog()->isReading(); }));
    return dialog();
  }
  void accept(ImportDialog& asked) {
    auto* button = asked.findChild<QPushButton*>(QStringLiteral("import"));
    ASSERT_TRUE(button->isEnabled()) << asked.findChild<QLabel*>(QStringLiteral("state"))->text().toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return !dialog(); }));
  }
  void choose(QWidget& of, const char* name, int index) {
    for (auto* combo : of.findChildren<QComboBox*>())
      if (combo->accessibleName() == QLatin1String(name)) {
        combo->setCurrentIndex(index);
        emit combo->activated(index);
        return;
      }
    ADD_FAILURE() << "no choice is called " << name;
  }
  /// By its words, as the menus and Ctrl+K have it.
  void trigger(const QString& words) {
    for (auto* action : window->actions())
      if (action->text() == words) {
        EXPECT_TRUE(action->isEnabled()) << action->toolTip().toStdString();
        action->trigger();
        rest(30);
        return;
      }
    ADD_FAILURE() << "no action says " << words.toStdString();
  }
  const std::vector<SolidSurface>& surfaces() {
    EXPECT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
    return *session->surfaces.current();
  }
  void openEmpty() {
    window->open(write("empty.talus", "{\"talus\": 1, \"materials\": {}, \"solids\": [], \"stages\": []}"));
    session->project.document();
  }
};

TEST_F(GeometryPage, AStepFileThatIsDroppedBecomesASolidThatIsSeen) {
  const fs::path step = fs::path(TALUS_SOURCE_DIR) / "samples/step_slope/slope.step";
  fs::create_directories(folder / "survey");
  fs::copy(step, folder / "survey/hill.step");
  accept(*importing(folder / "survey/hill.step"));
  ASSERT_EQ(project().solids.size(), 1U);
  EXPECT_EQ(project().solids[0].name, "hill");
  EXPECT_EQ(std::get<FileShape>(project().solids[0].shape).path, "hill.step");
  EXPECT_GT(surfaces().at(0).volume, 0);
  rest(100);
  EXPECT_TRUE(window->viewport().showsSolids());

  fs::create_directories(folder / "office");
  ASSERT_TRUE(session->project.saveAs(folder / "office/slope.talus"));
  EXPECT_TRUE(fs::exists(folder / "office/hill.step"));
  fs::copy(step, folder / "survey/ridge.step");
  accept(*importing(folder / "survey/ridge.step"));
  ASSERT_EQ(project().solids.size(), 2U);
  EXPECT_EQ(std::get<FileShape>(project().solids[1].shape).path, "ridge.step");
  EXPECT_TRUE(fs::exists(folder / "office/ridge.step")) << "copied beside the project";
  steps().undo();
  EXPECT_EQ(project().solids.size(), 1U);
}

TEST_F(GeometryPage, TrianglesInMillimetresWithYUpwardsAreImportedUpright) {
  window->open(slidingCube());
  auto* asked = importing(write("prism.stl", example::tall_prism));
  choose(*asked, "Unit of the file", 2);
  choose(*asked, "Axis of the file that points upwards", 1);
  ASSERT_TRUE(wait([&] { return !asked->isReading(); }));
  ASSERT_TRUE(asked->reading().surface);
  EXPECT_NEAR(asked->reading().surface->volume, 3, 1e-9);  // half of 1 × 3 × 2 m
  EXPECT_NEAR(asked->reading().surface->max.z() - asked->reading().surface->min.z(), 3, 1e-9);
  const int before = steps().count();
  accept(*asked);
  EXPECT_EQ(steps().count(), before + 1);
  ASSERT_EQ(project().solids.size(), 3U);
  EXPECT_DOUBLE_EQ(std::get<FileShape>(project().solids[2].shape).scale, 1e-3);
  EXPECT_NEAR(surfaces().at(2).volume, 3, 1e-9);
}

TEST_F(GeometryPage, TerrainOfASurveyGetsALocalOrigin) {
  std::string grid = "ncols 5\nnrows 4\nxllcorner 2600000\nyllcorner 1200000\ncellsize 10\nNODATA_value -9999\n";
  for (int row = 0; row < 4; ++row) grid += "500 510 520 530 540\n";
  auto* asked = importing(write("land.asc", grid));
  auto* shift = asked->findChild<QCheckBox*>(QStringLiteral("shift"));
  ASSERT_TRUE(wait([&] { return shift->isVisible() && !asked->isReading(); }));
  EXPECT_TRUE(shift->isChecked());
  accept(*asked);
  EXPECT_GT(project().origin.x(), 2.5e6);
  const SolidSurface& land = surfaces().at(0);
  EXPECT_LT(land.max.cwiseAbs().maxCoeff(), 1e4) << "near the local origin";
  const auto* shape = std::get_if<TerrainShape>(&project().solids.at(0).shape);
  ASSERT_TRUE(shape);
  const Vec3 size = land.max - land.min;
  EXPECT_NEAR(land.volume, size.x() * size.y() * (520 - project().origin.z() - shape->base), 1e-6 * land.volume);
  rest(50);
  auto* area = window->findChild<QWidget*>(QStringLiteral("view area"));
  QTest::mouseMove(area, pointOnBlock().toPoint());
  auto* pointed = window->findChild<QLabel*>(QStringLiteral("pointed"));
  ASSERT_TRUE(wait([&] { return !pointed->text().isEmpty(); }));
  const QString place = pointed->text().remove(QChar(0x2009));  // between thousands
  EXPECT_TRUE(place.startsWith(QStringLiteral("E 2600"))) << place.toStdString();
  EXPECT_TRUE(place.contains(QStringLiteral("N 1200"))) << place.toStdString();
  steps().undo();
  EXPECT_TRUE(project().solids.empty());
  EXPECT_TRUE(project().origin.isZero());
}

TEST_F(GeometryPage, WhatCannotBeImportedIsSaidInTheDialogAndChangesNothing) {
  window->open(slidingCube());
  const Project before = project();
  for (const auto& [name, content, said] : {std::tuple("hill.dwg", "solid hill", "'.dwg'"),
                                            {"rubbish.stl", "solid nothing\nendsolid nothing\n", ""},
                                            {"rubbish.step", "ISO-10303-21; nothing", ""}}) {
    auto* asked = importing(write(name, content));
    EXPECT_FALSE(asked->reading().surface) << name;
    const std::string state = asked->findChild<QLabel*>(QStringLiteral("state"))->text().toStdString();
    EXPECT_THAT(state, HasSubstr(said)) << name;
    EXPECT_THAT(state, HasSubstr("; ")) << "a remedy";
    EXPECT_FALSE(asked->findChild<QPushButton*>(QStringLiteral("import"))->isEnabled()) << name;
    asked->reject();
    ASSERT_TRUE(wait([&] { return !dialog(); }));
  }
  EXPECT_EQ(project(), before);
}

TEST_F(GeometryPage, APreviewIsMadeBesideTheWindowAndOnlyTheLastOneIsShown) {
  openEmpty();
  const auto prism = write("prism.stl", example::open_prism());
  auto* asked = importing(prism);
  auto& view = *asked->findChild<SolidViewport*>();
  ASSERT_TRUE(wait([&] { return !view.isEmpty(); }));
  NoProgress nobody;
  const SolidSurface surface = *readSolid(prism, {}, nobody).surface;
  view.clear();
  EXPECT_TRUE(view.isEmpty());
  view.setSolid(surface, true);
  EXPECT_TRUE(view.isEmpty()) << "it is not made on the window's thread";
  ASSERT_TRUE(wait([&] { return !view.isEmpty(); }));
  view.setSolid(surface, false);
  EXPECT_FALSE(view.isEmpty()) << "what was there before stays";
  view.clear();
  rest(200);
  EXPECT_TRUE(view.isEmpty()) << "what was taken away does not come back";
}

TEST_F(GeometryPage, ACornerOfASectionIsDraggedAndTakenBack) {
  window->open(slidingCube());
  trigger(QStringLiteral("New bench in section"));
  auto* editor = window->findChild<SectionEditor*>();
  ASSERT_TRUE(editor && editor->isVisible());
  rest(50);
  SectionPlot& plot = editor->plot();
  const auto corners = plot.corners();
  ASSERT_EQ(std::get<SectionShape>(project().solids.at(2).shape).points, corners);
  const QPoint from = plot.pixelOf(corners[1]).toPoint(), to = from + QPoint(20, 0);
  const int before = steps().count();
  QTest::mousePress(&plot, Qt::LeftButton, {}, from);
  QTest::mouseMove(&plot, (from + to) / 2);
  QTest::mouseMove(&plot, to);
  QTest::mouseRelease(&plot, Qt::LeftButton, {}, to);
  rest(50);
  EXPECT_EQ(steps().count(), before + 1) << "a drag is one step";
  const auto& moved = std::get<SectionShape>(project().solids[2].shape).points;
  EXPECT_GT(moved[1][0], corners[1][0] + 0.1);
  EXPECT_NEAR(moved[1][1], corners[1][1], 0.05) << "within a pixel";
  steps().undo();
  EXPECT_EQ(std::get<SectionShape>(project().solids[2].shape).points, corners);
}

TEST_F(GeometryPage, CornersOfASectionAreSeenLightAndDark) {
  window->open(slidingCube());
  trigger(QStringLiteral("New bench in section"));
  auto* editor = window->findChild<SectionEditor*>();
  ASSERT_TRUE(editor && editor->isVisible());
  SectionPlot& plot = editor->plot();
  for (const bool dark : {false, true}) {
    session->display.setDark(dark);
    rest(50);
    const QImage drawn = plot.grab().toImage();
    const int ground = qGray(drawn.pixel(plot.width() - 3, 3));
    int strongest = 0;
    const QPoint corner = plot.pixelOf(plot.corners()[1]).toPoint();
    for (int x = corner.x() - 6; x <= corner.x() + 6; ++x)
      for (int y = corner.y() - 6; y <= corner.y() + 6; ++y)
        strongest = std::max(strongest, std::abs(qGray(drawn.pixel(x, y)) - ground));
    EXPECT_GT(strongest, 128) << "of 255, " << (dark ? "dark" : "light");
  }
}

TEST_F(GeometryPage, ATunnelIsSubtractedFromABox) {
  window->open(
      write("rock.talus", R"({"talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.2}},
    "solids": [{"name": "rock", "box": {"min": [0, 0, 0], "max": [16, 10, 16]}, "material": "rock"}], "stages": []})"));
  ASSERT_EQ(surfaces().size(), 1U);
  trigger(QStringLiteral("New tunnel"));
  ASSERT_EQ(project().solids.size(), 2U);
  const auto tunnel = std::get<CylinderShape>(project().solids[1].shape);
  session->project.selection().selectSolids({0, 1});
  trigger(QStringLiteral("Subtract the last selected"));
  ASSERT_EQ(project().solids.size(), 3U);
  ASSERT_TRUE(wait([&] { return surfaces().size() == 1U; })) << "the parts are no bodies of their own";
  const double section =
      tunnel.sides / 2.0 * tunnel.radius * tunnel.radius * std::sin(2 * std::numbers::pi / tunnel.sides);
  EXPECT_NEAR(surfaces()[0].volume, 16 * 10 * 16 - 10 * section, 1e-6);
}

TEST_F(GeometryPage, MeasuresADistanceAndTheAttitudeOfAFace) {
  window->open(slidingCube());
  surfaces();
  rest(50);
  trigger(QStringLiteral("Measure"));
  auto* card = window->findChild<MeasureCard*>();
  ASSERT_TRUE(card && card->isVisible());
  session->picking.take({.solid = 0, .point = {2600000, 1200000, 1}});  // as a survey has them
  session->picking.take({.solid = 0, .point = {2600003, 1200004, 1}});
  rest(30);
  for (const auto* label : card->findChildren<QLabel*>())
    EXPECT_TRUE(label->wordWrap() || label->width() >= label->sizeHint().width()) << label->text().toStdString();
  ASSERT_FALSE(card->rows().empty());
  EXPECT_THAT(card->rows()[0].value.toStdString(), testing::StartsWith("5 m"));
  choose(*card, "What is measured", 0);
  const double side = std::sqrt(0.5);
  session->picking.take({.solid = 0, .point = {0, 0, 1}, .normal = {side, 0, side}});  // down to the east
  rest(30);
  std::string said;
  for (const MeasuredRow& row : card->rows()) said += row.value.toStdString() + "\n";
  EXPECT_THAT(said, HasSubstr("45/090"));
  QTest::keyClick(window.get(), Qt::Key_Escape);
  rest(30);
  EXPECT_FALSE(session->picking.isAsking());
}

/// Not a test: pictures of the page and its dialogs, into the folder that TALUS_PICTURES names.
TEST_F(GeometryPage, DISABLED_DrawsPictures) {
  const QString out = qEnvironmentVariable("TALUS_PICTURES");
  const bool dark = qEnvironmentVariableIsSet("TALUS_DARK");
  session->display.setDark(dark);
  auto* asked = importing(write("prism.stl", example::tall_prism));
  choose(*asked, "Unit of the file", 2);
  choose(*asked, "Axis of the file that points upwards", 1);
  ASSERT_TRUE(wait([&] { return !asked->isReading(); }));
  rest(400);
  asked->grab().save(out + QStringLiteral("/import.png"));
  accept(*asked);
  trigger(QStringLiteral("New bench in section"));
  surfaces();
  rest(600);
  window->findChild<SectionEditor*>()->grab().save(out + QStringLiteral("/section.png"));
  window->findChild<SectionEditor*>()->close();
  trigger(QStringLiteral("Measure"));
  rest(600);
  window->grab().save(out + QStringLiteral("/geometry.png"));
}

}  // namespace
}  // namespace talus
