#include <QComboBox>
#include <QTest>

#include "driven_window.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

/// Chooses an entry of a box by the keyboard, as a user does.
void chooseWithKeys(QComboBox& box, const QString& entry) {
  box.setFocus();
  for (int tries = 0; tries < box.count() && box.currentText() != entry; ++tries) QTest::keyClick(&box, Qt::Key_Down);
}

TEST_F(DrivenWindow, ShowsFieldsOfJointsOnTheirWalls) {
  openAndMesh(slidingCube(60));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() >= 60 && !session->run.job().isBusy(); }));
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));

  QComboBox *quantity = nullptr, *component = nullptr;
  for (QComboBox* box : window->findChildren<QComboBox*>()) {
    if (!box->isVisible()) continue;
    if (box->accessibleName() == QObject::tr("Colour by")) quantity = box;
    if (box->accessibleName() == QObject::tr("Component")) component = box;
  }
  ASSERT_TRUE(quantity && component);
  const QImage before = window->viewport().picture().toImage();
  chooseWithKeys(*quantity, QStringLiteral("Joints"));
  ASSERT_TRUE(session->display.settings().field);
  EXPECT_EQ(session->display.settings().field->source, Field::Source::joint);
  for (int i = 0; i < component->count(); ++i) {
    component->setFocus();
    chooseWithKeys(*component, component->itemText(i));
    EXPECT_EQ(session->display.settings().field->name, component->itemData(i).toString().toStdString());
    rest(100);
    EXPECT_NE(window->viewport().picture().toImage(), before) << component->itemText(i).toStdString();
  }
  EXPECT_EQ(component->count(), 8);
  EXPECT_EQ(component->itemText(0), QStringLiteral("Normal stress")) << "the first box says of what";
  EXPECT_TRUE(session->messages.problems().empty());
}

}  // namespace
}  // namespace talus
