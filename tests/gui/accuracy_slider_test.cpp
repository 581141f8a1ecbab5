#include "widgets/accuracy_slider.hpp"

#include <QLabel>
#include <QTest>
#include <algorithm>

#include "listed_runs.hpp"
#include "render/log_axis.hpp"
#include "studied_window.hpp"
#include "widgets/theme.hpp"

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

TEST_F(AccuracySliderTest, SaysHowToGetAStudyWhereThereIsNone) {
  openAndMesh(slidingCube(100));
  workspace->goTo(Step::solve);
  EXPECT_FALSE(slider().isEnabled());
  EXPECT_TRUE(says(QStringLiteral("talus-cli study accuracy cube.talus")));
  rest(2500);
  keepPicture(*window, "accuracy_slider_none.png");
}

TEST_F(AccuracySliderTest, GoesFromDraftToReferenceAndChangesTheProjectAsOneStep) {
  const auto file = slidingCube(100);
  study(file);
  openAndMesh(file);
  workspace->goTo(Step::solve);
  const Project before = workspace->document().project();
  const AccuracyStudy& study = workspace->study()->study;
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
  workspace->setDark(true);
  rest(300);
  keepPicture(*window, "accuracy_slider_dark.png");
  theme::install(false);
  click(button(panel(), "Use"));
  EXPECT_EQ(workspace->document().project(), wanted);
  EXPECT_TRUE(says(QStringLiteral("as the project is now")));
  EXPECT_FALSE(button(panel(), "Use").isEnabled());
  workspace->document().undoStack().undo();
  EXPECT_EQ(workspace->document().project(), before);

  Joint joint = before.joints[0];
  joint.friction_angle = 25;
  workspace->document().changeJoint(0, joint);
  EXPECT_FALSE(slider().isEnabled());
  EXPECT_TRUE(says(QStringLiteral("--restart")));
}

}  // namespace
}  // namespace talus
