// Results from end to end as an engineer uses them: opened, played, scrubbed, coloured, cut open, picked, plotted,
// compared, and handed over as each kind of file; which programs that know nothing of us then read.
#include <cstdlib>
#include <fstream>

#include "driven_window.hpp"
#include "session/compared_results.hpp"
#include "widgets/results/block_history_panel.hpp"
#include "widgets/view/compared_viewport.hpp"
#include "widgets/view/timeline.hpp"
#include "widgets/window/bottom_panel.hpp"

namespace talus {
namespace {

class HandingOver : public DrivenWindow {
 public:
  void solveAndOpenAnew();
  void play();
  void scrub();
  void colour();
  void cutOpen();
  void pick();
  void plot();
  void compare();
  void write();
  /// What tests/readers/read_back.py finds in the files that were written: empty where all is as it should be.
  std::string readBack() const;
};

void HandingOver::solveAndOpenAnew() {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return !session->playback.isLive() && !session->playback.folder().empty(); }));
  const auto results = session->playback.folder();
  openWindow();
  window->open(results);
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  ASSERT_EQ(session->playback.times().size(), 11u);  // 0.2 s, one every 0.02 s, and the start
}

void HandingOver::play() {
  window->timeline().togglePlay();
  ASSERT_TRUE(wait([&] { return session->playback.number() == 10 && !window->timeline().isPlaying(); }, 10000));
}

void HandingOver::scrub() {
  session->playback.showTime(0.099);
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 5; }));
}

void HandingOver::colour() {
  SceneSettings settings = session->display.settings();
  settings.field = field_named("velocity");
  session->display.set(settings);
  ASSERT_TRUE(wait([&] { return session->display.settings().range.has_value(); }));
  EXPECT_GT(session->display.settings().range->high, 0.1);
}

/// The hand that is near the viewer is gone: what is picked then lies behind the plane.
void HandingOver::cutOpen() {
  SceneSettings settings = session->display.settings();
  settings.section = SectionPlane{Vec3(0, 2, 0), -Vec3::UnitY()};
  session->display.set(settings);
  window->viewport().look(View::front);
  ASSERT_TRUE(wait([&] {
    const auto found = window->viewport().pickAt(pointOnBlock());
    return found && found->position.y() > 2 - 1e-6;
  }));
  settings.section.reset();
  session->display.set(settings);
}

void HandingOver::pick() {
  window->viewport().look(View::iso);
  rest(100);
  std::optional<Pick> cube;
  for (int y = 10; y < window->viewport().height() && !cube; y += 6)
    for (int x = 10; x < window->viewport().width() && !cube; x += 6) {
      const auto found = window->viewport().pickAt(QPointF(x, y));
      if (found && found->block == 1) cube = found;
    }
  ASSERT_TRUE(cube && cube->value);
  const double a = 4.905 - 8.496 * std::tan(M_PI / 18);  // g (sin 30° − tan 10° cos 30°)
  EXPECT_NEAR(*cube->value, a * session->playback.time(), 0.02 * a);
}

void HandingOver::plot() {
  auto* tabs = window->findChild<BottomPanel*>();
  auto* panel = tabs->findChild<BlockHistoryPanel*>();
  tabs->setCurrentWidget(panel);
  session->project.selection().select({Item::Kind::block, 1});
  ASSERT_TRUE(wait([&] { return session->histories.history() != nullptr; }));
  EXPECT_EQ(panel->findChild<Plot*>()->curves().at(0).x.size(), 11u);
}

void HandingOver::compare() {
  const auto other = folder / "other.results";
  std::filesystem::copy(session->playback.folder(), other, std::filesystem::copy_options::recursive);
  window->compareWith(other);
  const auto& runs = session->compared.runs();
  ASSERT_TRUE(wait([&] { return !runs.empty() && runs.front()->frame(); }));
  EXPECT_EQ(runs.front()->frame()->index, session->playback.frame()->index);
  ASSERT_TRUE(wait([&] {
    const auto* beside = window->findChild<ComparedViewport*>();
    return beside && beside->isVisible() && beside->scene();
  }));
  session->compared.close(*runs.front());
  rest(100);  // the view has all the room again
}

void HandingOver::write() {
  window->savePicture(folder / "picture.png");
  window->saveFilm(folder / "film.mp4");
  window->saveFilm(folder / "film.gif");
  window->saveReport(folder / "report.html");
  window->saveReport(folder / "report.pdf");
  window->exportData(DataFormat::csv, folder / "tables");
  window->exportData(DataFormat::vtu, folder / "vtu");
  window->exportData(DataFormat::stl, folder / "deposit.stl");
  window->exportData(DataFormat::gltf, folder / "slide.glb");
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  for (const Problem& problem : session->messages.problems()) ADD_FAILURE() << problem.problem.toStdString();
}

std::string HandingOver::readBack() const {
  const std::string command = "/usr/bin/python3 " TALUS_SOURCE_DIR "/tests/readers/read_back.py '" + folder.string() +
                              "' > '" + (folder / "said.txt").string() + "' 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream said(folder / "said.txt");
  const std::string text(std::istreambuf_iterator<char>(said), {});
  std::printf("%s", text.c_str());
  return status == 0 ? "" : text + "status " + std::to_string(status);
}

TEST_F(HandingOver, ResultsAreLookedAtInEveryWayAndWhatIsWrittenIsReadByOthers) {
  solveAndOpenAnew();
  for (auto step : {&HandingOver::play, &HandingOver::scrub, &HandingOver::colour, &HandingOver::cutOpen,
                    &HandingOver::pick, &HandingOver::plot, &HandingOver::compare, &HandingOver::write}) {
    if (HasFatalFailure()) return;
    (this->*step)();
  }
  if (HasFatalFailure()) return;
  EXPECT_EQ(readBack(), "");
}

}  // namespace
}  // namespace talus
