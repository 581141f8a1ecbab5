#include "widgets/study/accuracy_slider.hpp"

#include <QLabel>
#include <QProgressBar>
#include <QTest>
#include <algorithm>

#include "listed_runs.hpp"
#include "render/charts/log_axis.hpp"
#include "studied_window.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {
namespace {

class AccuracySliderTest : public StudiedWindow {
 protected:
  AccuracySlider& panel() const { return *window->findChild<AccuracySlider*>(); }
  QSlider& slider() const { return *panel().findChild<QSlider*>(); }
  bool says(const QString& words) const {
    const auto labels = panel().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text().contains(words); });
  }
};

TEST_F(AccuracySliderTest, MakesAStudyThatCanBeStoppedAndGoneOnWith) {
  warmUp();
  qputenv("TALUS_CLI", TALUS_CLI);
  const auto file = slidingCube(20);
  openAndMesh(file);
  session->display.goTo(WorkflowPage::solve);
  EXPECT_FALSE(slider().isEnabled());
  EXPECT_TRUE(says(QStringLiteral("not known yet")));
  rest(2500);
  keepPicture(*window, "accuracy_slider_none.png");

  const auto runs = [&] {
    int count = 0;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(study_folder_of(file) / "runs", none))
      count += entry.path().extension() == ".json" ? 1 : 0;
    return count;
  };
  click(button(panel(), "Study accuracy"));
  ASSERT_TRUE(wait([&] { return runs() >= 2; }));
  EXPECT_TRUE(says(QStringLiteral("runs have ended")));
  keepPicture(*window, "accuracy_slider_study.png");
  theme::install(true);
  session->display.setDark(true);
  rest(200);
  keepPicture(*window, "accuracy_slider_study_dark.png");
  theme::install(false);
  session->display.setDark(false);
  rest(100);
  expectNoWait([&](const Watchdog&) {
    if (says(QStringLiteral("not known yet"))) click(button(panel(), "Study accuracy"));
    rest(500);
    click(button(panel(), "Stop"));
    ASSERT_TRUE(wait([&] { return says(QStringLiteral("not known yet")); }));
  });
  EXPECT_FALSE(slider().isEnabled());
  EXPECT_GE(runs(), 2) << "what has ended is kept";

  click(button(panel(), "Study accuracy"));
  ASSERT_TRUE(wait([&] { return slider().isEnabled(); })) << session->messages.problems().size();
  EXPECT_TRUE(session->project.study()->study.complete());
  for (const char* name : {"accuracy.csv", "accuracy.json", "accuracy.png"})
    EXPECT_TRUE(std::filesystem::exists(study_folder_of(file) / name)) << name;
  EXPECT_TRUE(says(QStringLiteral("error ")));
}

TEST_F(AccuracySliderTest, OffersAStudyOfAProjectThatTakesTheStudiedOnesPlace) {
  const auto file = slidingCube(100);
  study(file);
  window->open(file);
  session->display.goTo(WorkflowPage::solve);
  ASSERT_TRUE(slider().isEnabled());
  window->open(sample("free_fall"));
  session->display.goTo(WorkflowPage::solve);
  EXPECT_FALSE(slider().isEnabled());
  EXPECT_TRUE(says(QStringLiteral("not known yet")));
  EXPECT_TRUE(button(panel(), "Study accuracy").isVisible());
}

TEST_F(AccuracySliderTest, IsDraggedFromDraftToReference) {
  const auto file = slidingCube(100);
  study(file);
  openAndMesh(file);
  session->display.goTo(WorkflowPage::solve);
  rest(300);
  QSlider& one = slider();
  ASSERT_TRUE(one.isEnabled());
  one.setValue(0);
  const int middle = one.height() / 2;
  QTest::mousePress(&one, Qt::LeftButton, {}, QPoint(8, middle));
  QTest::mouseMove(&one, QPoint(one.width() / 2, middle));
  QTest::mouseMove(&one, QPoint(one.width() - 2, middle));
  QTest::mouseRelease(&one, Qt::LeftButton, {}, QPoint(one.width() - 2, middle));
  EXPECT_EQ(one.value(), one.maximum());
  const AccuracyStudy& made = session->project.study()->study;
  const AccuracyRow& finest = made.rows[static_cast<std::size_t>(best_by_cost(made).back())];
  EXPECT_TRUE(says(QString::fromStdString(error_text(*finest.error))));
}

TEST_F(AccuracySliderTest, GoesFromDraftToReferenceAndChangesTheProjectAsOneStep) {
  const auto file = slidingCube(100);
  study(file);
  openAndMesh(file);
  session->display.goTo(WorkflowPage::solve);
  const Project before = session->project.document().project();
  const AccuracyStudy& study = session->project.study()->study;
  const std::vector<int> best = best_by_cost(study);
  ASSERT_GE(best.size(), 2u);
  ASSERT_TRUE(slider().isEnabled());
  EXPECT_EQ(slider().maximum(), static_cast<int>(best.size()) - 1);

  for (const int run : best) {
    slider().setValue(static_cast<int>(std::find(best.begin(), best.end(), run) - best.begin()));
    const AccuracyRow& chosen = study.rows[static_cast<std::size_t>(run)];
    EXPECT_TRUE(says(QString::fromStdString(error_text(*chosen.error))));
    EXPECT_TRUE(says(QString::fromStdString(chosen.label)));
  }
  const bool other_first = best.front() != 0;
  const int other = other_first ? best.front() : best.back();
  slider().setValue(other_first ? 0 : slider().maximum());
  const Project wanted = under(study.rows[static_cast<std::size_t>(other)].setting, before);
  rest(2500);
  keepPicture(*window, "accuracy_slider.png");
  theme::install(true);
  session->display.setDark(true);
  rest(300);
  keepPicture(*window, "accuracy_slider_dark.png");
  theme::install(false);
  click(button(panel(), "Use"));
  EXPECT_EQ(session->project.document().project(), wanted);
  EXPECT_TRUE(says(QStringLiteral("as the project is now")));
  EXPECT_FALSE(button(panel(), "Use").isEnabled());
  session->project.document().undoStack().undo();
  EXPECT_EQ(session->project.document().project(), before);

  Project changed = before;
  changed.joints[0].friction_angle = 25;
  session->project.document().change(changed, {});
  EXPECT_FALSE(slider().isEnabled());
  EXPECT_TRUE(says(QStringLiteral("before it was changed")));
  EXPECT_FALSE(button(panel(), "Study again").isEnabled()) << "a study is made of the file";
  session->project.save();
  EXPECT_TRUE(button(panel(), "Study again").isEnabled());
  rest(50);
  keepPicture(*window, "accuracy_slider_again.png");
}

}  // namespace
}  // namespace talus
