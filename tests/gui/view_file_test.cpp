#include <QImage>
#include <QTest>

#include <QPainter>
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "driven_window.hpp"
#include "widgets/view/compared_viewport.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

class ViewFile : public DrivenWindow {
 protected:
  void openResults() {
    openAndMesh(slidingCube(60));
    session->solve();
    ASSERT_TRUE(wait([&] { return session->run.steps().size() >= 60 && !session->run.job().isBusy(); }));
    ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
    rest(500);  // the fine drawing comes when the camera has rested
  }

  /// What talus-cli draws of the results by a view file.
  QImage drawnByCommand(const std::filesystem::path& view) {
    const std::filesystem::path picture = folder / "by_command.png";
    const std::string command = std::string(TALUS_CLI) + " render " + session->playback.folder().string() +
                                " --view-file " + view.string() + " --out " + picture.string() + " > /dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return QImage(QString::fromStdString(picture.string())).convertToFormat(QImage::Format_RGB32);
  }

  QImage shown() { return window->viewport().picture().toImage().convertToFormat(QImage::Format_RGB32); }

  /// All that stands side by side, as it is seen but for its buttons.
  QImage shownSideBySide() {
    QWidget& area = *window->viewport().parentWidget();
    QImage all = area.grab().toImage().convertToFormat(QImage::Format_RGB32);
    QPainter painter(&all);
    painter.drawPixmap(window->viewport().pos(), window->viewport().picture());
    for (auto* view : area.findChildren<ComparedViewport*>())
      if (view->isVisible()) painter.drawPixmap(view->pos(), view->surface().picture());
    return all;
  }

  /// How many pixels of two pictures of one size differ.
  static int differing(const QImage& a, const QImage& b) {
    EXPECT_EQ(a.size(), b.size());
    int count = 0;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y)
      for (int x = 0; x < std::min(a.width(), b.width()); ++x) count += a.pixel(x, y) != b.pixel(x, y);
    return count;
  }
};

TEST_F(ViewFile, IsDrawnByTheCommandAsTheWindowShowsItToTheBit) {
  openResults();
  session->playback.showFrame(1);
  ASSERT_TRUE(wait([&] { return session->playback.number() == 1 && !session->playback.isWaiting(); }));
  const auto view = folder / "slope.view.json";
  for (const char* field : {"displacement", "stress.zz", "joint.slip", "joint.state", "rotation", "body", ""}) {
    SceneSettings settings = session->display.settings();
    settings.field.reset();
    if (*field) settings.field = field_named(field);
    session->display.set(settings);
    rest(500);
    window->saveView(view);
    EXPECT_EQ(differing(shown(), drawnByCommand(view)), 0) << field;
  }
  // All else at once.
  SceneSettings settings = session->display.settings();
  settings.field = field_named("velocity");
  settings.edges = Edges::mesh;
  settings.deformation_scale = 10;
  settings.only = ValueRange{0.001, 0.1};
  settings.arrows = Arrows::velocity;
  settings.contacts = true;
  settings.trails = Trails::all;
  settings.probed_line = std::array{Vec3(0, 2, 2), Vec3(6, 2, 4)};
  settings.scale_bar = false;
  session->display.set(settings);
  session->display.setTypedRange(ValueRange{0, 0.123});
  session->display.setDark(true);
  window->viewport().toggleProjection();
  window->viewport().toggleSection();
  session->project.selection().selectBlocks({1});
  ASSERT_TRUE(wait([&] { return session->trails.trails() != nullptr; }));
  rest(600);
  window->saveView(view);
  const QImage all = shown();
  EXPECT_EQ(differing(all, drawnByCommand(view)), 0);

  // The window shows it again, whatever it was made to show meanwhile.
  settings = session->display.settings();
  settings.field = field_named("joint.opening");
  settings.edges = Edges::none;
  settings.section.reset();
  settings.contacts = false;
  session->display.set(settings);
  session->display.setDark(false);
  session->project.selection().clear();
  window->viewport().toggleProjection();
  window->viewport().look(View::top);
  session->playback.showFrame(3);
  rest(600);
  EXPECT_GT(differing(all, shown()), 1000);
  window->openView(view);
  ASSERT_TRUE(wait([&] { return session->playback.number() == 1 && !session->playback.isWaiting(); }));
  rest(600);
  EXPECT_EQ(differing(all, shown()), 0);
  EXPECT_TRUE(session->messages.problems().empty());
}

TEST_F(ViewFile, WithWhatIsComparedIsDrawnByTheCommandToTheBit) {
  openResults();
  for (const int steps : {30, 45}) {  // others end before the moment in view
    const std::string name = (folder / ("steps" + std::to_string(steps))).string();
    const std::string command = std::string(TALUS_CLI) + " solve " + slidingCube(steps).string() + " --out " + name +
                                ".results > /dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    window->compareWith(name + ".results");
  }
  const auto& runs = session->compared.runs();
  const auto areThere = [&] {
    return runs.size() == 2 && std::ranges::all_of(runs, [](const auto& run) { return run->frame() != nullptr; });
  };
  ASSERT_TRUE(wait(areThere));
  SceneSettings settings = session->display.settings();
  settings.field = field_named("displacement");
  session->display.set(settings);
  session->compared.setOver(*runs[1], true);
  std::filesystem::create_directory(folder / "views");
  const auto view = folder / "views" / "both.view.json";
  for (const bool dark : {false, true}) {
    session->display.setDark(dark);
    rest(600);
    window->saveView(view);
    EXPECT_EQ(differing(shownSideBySide(), drawnByCommand(view)), 0) << dark;
  }
  const QImage both = shownSideBySide();
  keepPicture(*window, "view_of_three.png");

  const std::string film = std::string(TALUS_CLI) + " animate " + session->playback.folder().string() +
                           " --view-file " + view.string() + " --size 640x400 --json --out " +
                           (folder / "three.mp4").string() + " > " + (folder / "said.json").string();
  ASSERT_EQ(std::system(film.c_str()), 0);
  std::ifstream said(folder / "said.json");
  const std::string text(std::istreambuf_iterator<char>(said), {});
  EXPECT_NE(text.find("\"frames\": 17"), std::string::npos) << "7, 4 and 6: " << text;

  // The window shows it again.
  while (!runs.empty()) session->compared.close(*runs.front());
  session->display.setDark(false);
  window->viewport().look(View::top);
  rest(600);
  window->openView(view);
  ASSERT_TRUE(wait(areThere));
  rest(1000);
  EXPECT_TRUE(session->compared.isOver(*runs[1]));
  EXPECT_EQ(differing(both, shownSideBySide()), 0);
  EXPECT_TRUE(session->messages.problems().empty());

  std::filesystem::rename(folder / "steps45.results", folder / "gone.results");
  const std::string command = std::string(TALUS_CLI) + " render " + session->playback.folder().string() +
                              " --view-file " + view.string() + " --out " + (folder / "no.png").string() +
                              " > /dev/null 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0) << "nothing is left out without a word";
}

TEST_F(ViewFile, ThatIsWrongIsSaidAndChangesNothing) {
  openResults();
  const SavedView before = *window->viewport().savedView();
  window->openView(write("wrong.json", "{\"talus_view\": 1, \"size\": [1, 2]}"));
  ASSERT_EQ(session->messages.problems().size(), 1u);
  EXPECT_TRUE(session->messages.problems()[0].place.contains(QStringLiteral("wrong.json")));
  rest(300);
  SavedView after = *window->viewport().savedView();
  EXPECT_GT(before.height, after.height) << "the list of problems has opened";
  after.height = before.height;
  after.covered = before.covered;
  after.camera = before.camera;  // was fitted anew
  EXPECT_EQ(view_text(after), view_text(before));
}

}  // namespace
}  // namespace talus
