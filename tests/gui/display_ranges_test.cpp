#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QTest>

#include "driven_window.hpp"
#include "widgets/results/range_fields.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

template <class Widget>
Widget* named(const QWidget& window, const QString& name) {
  for (auto* one : window.findChildren<Widget*>())
    if (one->isVisible() && (one->accessibleName() == name)) return one;
  return nullptr;
}

void typeInto(QLineEdit& field, const QString& text) {
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, text);
  QTest::keyClick(&field, Qt::Key_Return);
}

TEST_F(DrivenWindow, RangeOfTheLegendIsTypedAndStaysWhateverIsLookedAt) {
  openAndMesh(slidingCube(60));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() >= 60 && !session->run.job().isBusy(); }));
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));

  auto* range = named<QComboBox>(*window, QStringLiteral("Range of the legend"));
  ASSERT_TRUE(range);
  range->setFocus();
  QTest::keyClick(range, Qt::Key_End);
  ASSERT_TRUE(session->display.typedRange());
  rest(100);
  auto* highest = named<QLineEdit>(*window, QStringLiteral("Range of the legend, highest"));
  auto* lowest = named<QLineEdit>(*window, QStringLiteral("Range of the legend, lowest"));
  ASSERT_TRUE(highest && lowest);
  typeInto(*highest, QStringLiteral("25 mm"));
  EXPECT_DOUBLE_EQ(session->display.typedRange()->high, 0.025);
  typeInto(*lowest, QStringLiteral("1"));
  EXPECT_DOUBLE_EQ(session->display.typedRange()->low, 0) << "above the highest";
  for (const int frame : {0, 2, 1}) {
    session->playback.showFrame(frame);
    ASSERT_TRUE(wait([&] { return session->playback.number() == frame && !session->playback.isWaiting(); }));
    EXPECT_EQ(session->display.settings().range, (ValueRange{0, 0.025}));
  }

  QCheckBox* only = nullptr;
  for (auto* box : window->findChildren<QCheckBox*>())
    if (box->isVisible() && box->text() == QStringLiteral("Only values")) only = box;
  ASSERT_TRUE(only);
  rest(400);
  const QImage before = window->viewport().picture().toImage();
  QTest::mouseClick(only, Qt::LeftButton, {}, QPoint(10, only->height() / 2));
  ASSERT_TRUE(session->display.settings().only);
  rest(100);
  auto* least = named<QLineEdit>(*window, QStringLiteral("Values that are drawn, lowest"));
  ASSERT_TRUE(least);
  typeInto(*least, QStringLiteral("0.02"));
  EXPECT_DOUBLE_EQ(session->display.settings().only->low, 0.02);
  rest(400);
  EXPECT_NE(window->viewport().picture().toImage(), before);

  SceneSettings settings = session->display.settings();
  settings.field = field_named("velocity");
  session->display.set(settings);
  EXPECT_FALSE(session->display.typedRange()) << "it was of another field";
  EXPECT_FALSE(session->display.settings().only);
  settings = session->display.settings();
  settings.field = field_named("displacement");
  session->display.set(settings);
  ASSERT_TRUE(session->display.settings().only) << "each field keeps which values alone are drawn of it";
  EXPECT_DOUBLE_EQ(session->display.settings().only->low, 0.02);
  EXPECT_TRUE(only->isChecked());
  EXPECT_EQ(session->display.settings().range, (ValueRange{0, 0.025})) << "each field keeps what was typed of it";
  EXPECT_EQ(range->currentIndex(), 2);
}

}  // namespace
}  // namespace talus
