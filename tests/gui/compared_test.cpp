#include "widgets/view/compared_viewport.hpp"

#include <QToolButton>
#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "driven_window.hpp"
#include "session/compared_results.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

QToolButton* toolTipped(const QWidget& in, const char* tip) {
  for (auto* tool : in.findChildren<QToolButton*>())
    if (tool->toolTip() == QLatin1String(tip)) return tool;
  throw std::runtime_error(std::string("there is no button: ") + tip);
}

auto shownBeside(const QWidget& window) {
  return std::ranges::count_if(window.findChildren<ComparedViewport*>(), &QWidget::isVisible);
}

TEST_F(DrivenWindow, OtherResultsAreShownBesideAtTheSameMomentFromTheSamePlace) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return !session->playback.isLive() && !session->playback.folder().empty(); }));
  const auto other = folder / "other.results";
  std::filesystem::copy(session->playback.folder(), other, std::filesystem::copy_options::recursive);
  ASSERT_FALSE(window->findChild<ComparedViewport*>());

  window->compareWith(other);
  ASSERT_TRUE(wait([&] { return session->compared.runs().size() == 1; }));
  const auto run = session->compared.runs().front();
  auto* beside = window->findChild<ComparedViewport*>();
  ASSERT_TRUE(wait([&] { return beside->isVisible() && beside->scene() && run->frame(); }));
  session->playback.showFrame(3);
  ASSERT_TRUE(wait([&] { return run->frame()->index == 3; }));
  const auto same = [&] {
    return (beside->scene()->pose().position - window->viewport().pose()->position).norm() < 1e-9;
  };
  ASSERT_TRUE(wait(same));

  const CameraPose before = *window->viewport().pose();
  QWidget& surface = *beside->surface().widget();
  drag(surface, {60, 60}, {120, 80});
  EXPECT_GT((window->viewport().pose()->position - before.position).norm(), 0.1) << "turned in the other one";
  EXPECT_TRUE(wait(same));
  window->viewport().look(View::top);
  EXPECT_TRUE(wait(same));

  QTest::mouseClick(toolTipped(*beside, "End comparing"), Qt::LeftButton);
  EXPECT_TRUE(session->compared.runs().empty());
  EXPECT_EQ(shownBeside(*window), 0);
  window->compareWith(folder / "none.results");
  ASSERT_TRUE(wait([&] { return !session->messages.problems().empty(); }));
  EXPECT_EQ(shownBeside(*window), 0);
}

TEST_F(DrivenWindow, SeveralResultsAreComparedAndDrawnOverEachOther) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return !session->playback.isLive() && !session->playback.folder().empty(); }));
  for (const char* name : {"a/cube.results", "b/cube.results", "c/other.results", "d/fourth.results"}) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::filesystem::copy(session->playback.folder(), folder / name, std::filesystem::copy_options::recursive);
    window->compareWith(folder / name);
  }
  ASSERT_TRUE(wait([&] { return session->compared.runs().size() == 3; }));
  EXPECT_EQ(session->messages.problems().size(), 1u) << "a fourth is refused";
  const auto& runs = session->compared.runs();
  EXPECT_EQ(session->compared.nameOf(*runs[0]), QStringLiteral("a/cube"));
  EXPECT_EQ(session->compared.nameOf(*runs[1]), QStringLiteral("b/cube"));
  EXPECT_EQ(session->compared.nameOf(*runs[2]), QStringLiteral("other"));
  auto views = window->findChildren<ComparedViewport*>();
  ASSERT_EQ(views.size(), 3);
  rest(100);
  std::ranges::sort(views, {}, [](const QWidget* view) { return std::pair(view->y(), view->x()); });
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(&views[i]->run(), runs[static_cast<std::size_t>(i)].get()) << "in rows, as they were asked for";
  const QRect first = window->viewport().geometry();
  EXPECT_NEAR(views[2]->width(), first.width(), 2) << "four in two rows";
  EXPECT_NEAR(views[2]->height(), first.height(), 2);
  const auto together = [&] {
    return std::ranges::all_of(views, [&](const ComparedViewport* view) {
      return view->scene() && (view->scene()->pose().position - window->viewport().pose()->position).norm() < 1e-9;
    });
  };
  EXPECT_TRUE(wait(together)) << "the first one was fitted anew when it became smaller";
  for (auto* view : views) ASSERT_TRUE(wait([&] { return view->scene() && view->run().frame(); }));
  rest(500);
  keepPicture(*window, "compared.png");

  const QImage alone = window->viewport().picture().toImage();
  QTest::mouseClick(toolTipped(*views[0], "Draw its blocks' edges over the view beside it"), Qt::LeftButton);
  rest(500);
  EXPECT_EQ(window->viewport().ghost().name, "a/cube");
  EXPECT_NE(window->viewport().picture().toImage(), alone);
  keepPicture(*window, "over.png");

  constexpr int width = 640;
  const auto heightOfFilm = [&](bool over) {
    const auto file = folder / (over ? "over.mp4" : "beside.mp4");
    window->saveFilm(file, {.width = width, .over = over});
    EXPECT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
    std::ifstream film(file, std::ios::binary);
    const std::string data(std::istreambuf_iterator<char>(film), {});
    const auto entry = data.find("avc1", data.find("stsd"));  // 28 bytes behind it: width and height, two bytes each
    if (entry == std::string::npos) return -1;
    return 256 * static_cast<unsigned char>(data[entry + 30]) + static_cast<unsigned char>(data[entry + 31]);
  };
  const QSize view = window->viewport().size(), all = window->viewport().parentWidget()->size();
  EXPECT_NEAR(heightOfFilm(true), width * view.height() / view.width(), 2) << "in the view's shape";
  EXPECT_NEAR(heightOfFilm(false), width * all.height() / all.width(), 2) << "in that of all of them";

  window->savePicture(folder / "four.png");
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  const QImage saved(QString::fromStdString((folder / "four.png").string()));
  ASSERT_FALSE(saved.isNull());
  EXPECT_NEAR(saved.height(), saved.width() * all.height() / all.width(), 2);
  const auto shareOfRock = [&](const QRect& part) {  // which is darker than what is behind it
    int dark = 0;
    for (int y = part.top(); y < part.bottom(); ++y)
      for (int x = part.left(); x < part.right(); ++x) dark += saved.pixelColor(x, y).value() < 190;
    return static_cast<double>(dark) / part.width() / part.height();
  };
  const int w = saved.width() / 2, h = saved.height() / 2;
  for (const QPoint place : {QPoint(w, 0), QPoint(0, h), QPoint(w, h)})
    EXPECT_NEAR(shareOfRock(QRect(place, QSize(w, h))), shareOfRock(QRect(0, 0, w, h)), 0.02) << "as in the first";
  EXPECT_GT(shareOfRock(QRect(0, 0, w, h)), 0.01) << "more than letters";
  session->compared.close(*runs[0]);
  EXPECT_EQ(shownBeside(*window), 2);
  rest(100);
  const QWidget& area = *window->viewport().parentWidget();
  const QRect one = views[1]->geometry(), other = views[2]->geometry();
  EXPECT_GT(one.left(), window->viewport().geometry().right()) << "the next takes its place";
  EXPECT_GT(other.top(), one.bottom());
  EXPECT_EQ(other.width(), area.width()) << "the last one has the rest of its row";
  EXPECT_FALSE(window->viewport().ghost().system) << "it goes with its view";
}

}  // namespace
}  // namespace talus
