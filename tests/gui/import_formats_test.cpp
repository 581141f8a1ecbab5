// Solids and ground of every kind of file that is no mesh: dropped on the window, looked at, taken into the project.
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "driven_window.hpp"
#include "geometry/solid_surface.hpp"
#include "unit/geometry/geotiff_file.hpp"
#include "unit/geometry/iges_file.hpp"
#include "widgets/geometry/import_dialog.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

class ImportedFormats : public DrivenWindow {
 protected:
  const Project& project() { return session->project.document().project(); }
  /// The surface of the only solid after its file has been dropped, read and taken.
  SolidSurface imported(const fs::path& file) {
    window->open(write("empty.talus", R"({"talus": 1, "materials": {}, "solids": [], "stages": []})"));
    drop(file);
    auto* asked = window->findChild<ImportDialog*>();
    EXPECT_TRUE(asked && wait([&] { return !asked->isReading(); }));
    auto* take = asked->findChild<QPushButton*>(QStringLiteral("import"));
    EXPECT_TRUE(take->isEnabled()) << asked->findChild<QLabel*>(QStringLiteral("state"))->text().toStdString();
    QTest::mouseClick(take, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
    EXPECT_EQ(project().solids.size(), 1u);
    EXPECT_TRUE(session->surfaces.problems().empty());
    rest(100);
    EXPECT_TRUE(window->viewport().showsSolids());
    EXPECT_GE(pointOnBlock().x(), 0) << "it is drawn";
    return session->surfaces.current()->at(0);
  }
  bool isInTheTree(const QString& name) {
    for (const auto* tree : window->findChildren<QTreeWidget*>())
      if (!tree->findItems(name, Qt::MatchExactly | Qt::MatchRecursive).isEmpty()) return true;
    return false;
  }
};

TEST_F(ImportedFormats, AnIgesFileOfLooseFacesBecomesASolid) {
  const SolidSurface box = imported(write("box.igs", rock::iges_of(rock::faces_of_box({10, 8, 6}), "6,1HM")));
  EXPECT_NEAR(box.volume, 480, 1e-6);
  EXPECT_EQ(std::get<FileShape>(project().solids[0].shape).path, "box.igs");
  EXPECT_TRUE(isInTheTree(QStringLiteral("box")));
}

TEST_F(ImportedFormats, ABrepFileBecomesASolid) {
  fs::copy(fs::path(TALUS_SOURCE_DIR) / "tests/gui/box.brep", folder / "slab.brep");
  const SolidSurface box = imported(folder / "slab.brep");
  EXPECT_NEAR(box.volume, 480, 1e-6);
  EXPECT_TRUE(box.closed);
  EXPECT_EQ(std::get<FileShape>(project().solids[0].shape).path, "slab.brep");
  EXPECT_TRUE(isInTheTree(QStringLiteral("slab")));
}

TEST_F(ImportedFormats, AGeoTiffBecomesTerrain) {
  const SolidSurface ground =
      imported(write("ground.tif", rock::geotiff(3, 2, 10, 600000, 5000020, {11, 12, 13, 11, 12, 13})));
  const auto* terrain = std::get_if<TerrainShape>(&project().solids[0].shape);
  ASSERT_TRUE(terrain);
  EXPECT_EQ(terrain->path, "ground.tif");
  EXPECT_FALSE(project().origin.isZero()) << "near a local origin";
  const Vec3 size = ground.max - ground.min;
  EXPECT_NEAR(size.x(), 20, 1e-9);
  EXPECT_NEAR(size.y(), 10, 1e-9);
  EXPECT_NEAR(ground.volume, 20 * 10 * (12 - project().origin.z() - terrain->base), 1e-6);
  EXPECT_TRUE(isInTheTree(QStringLiteral("ground")));
}

}  // namespace
}  // namespace talus
