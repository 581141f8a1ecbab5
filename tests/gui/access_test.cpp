// Everything that takes the keyboard has a name that a screen reader can say, and F1 leads to the manual.
#include <QAbstractScrollArea>
#include <QAccessible>
#include <QAction>
#include <QLineEdit>
#include <QTabBar>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/window/manual_window.hpp"

namespace talus {
namespace {

/// Takes the keyboard for itself, not for what is in it.
bool isInteractive(const QWidget& widget) {
  if (!(widget.focusPolicy() & Qt::TabFocus) || widget.focusProxy() || widget.inherits("QScrollArea")) return false;
  for (const char* container : {"QStackedWidget", "QTabWidget", "QMenu", "QDockWidget", "QRubberBand"})
    if (widget.inherits(container)) return false;
  return !widget.objectName().startsWith(QStringLiteral("qt_"));
}

QString nameOf(QWidget& widget) {
  auto* access = QAccessible::queryAccessibleInterface(&widget);
  return access ? access->text(QAccessible::Name) : widget.accessibleName();
}

using Access = DrivenWindow;

TEST_F(Access, EveryWidgetThatTakesTheKeyboardHasAName) {
  openAndMesh(slidingCube(40));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  std::vector<Item> items{
      {}, {Item::Kind::block, 1}, {Item::Kind::joint, 0}, {Item::Kind::material, 0}, {Item::Kind::solid, 1}};
  int seen = 0;
  for (const WorkflowPage page : all_pages)
    for (const Item& item : items) {
      session->display.goTo(page);
      session->project.selection().select(item);
      rest(10);
      for (auto* widget : window->findChildren<QWidget*>()) {
        const bool popsUp = widget->window() != window.get();
        if (popsUp || !isInteractive(*widget)) continue;
        ++seen;
        EXPECT_FALSE(nameOf(*widget).trimmed().isEmpty())
            << pageKey(page) << ": " << widget->metaObject()->className() << " " << widget->objectName().toStdString()
            << " in " << widget->parentWidget()->metaObject()->className();
      }
      if (HasFailure()) return;
    }
  EXPECT_GT(seen, 500);
}

TEST_F(Access, F1OpensTheManualWhereItTellsOfWhatIsSelected) {
  window->open(slidingCube(40));
  session->display.goTo(WorkflowPage::materials);
  window->activateWindow();
  QTest::keyClick(window.get(), Qt::Key_F1);
  auto* manual = window->findChild<ManualWindow*>();
  ASSERT_NE(manual, nullptr);
  EXPECT_TRUE(manual->isVisible());
  auto* pages = manual->findChild<QTextBrowser*>();
  EXPECT_EQ(pages->textCursor().block().text(), QStringLiteral("Materials"));
  rest(100);
  keepPicture(*manual, "manual.png");
  for (const WorkflowPage page : all_pages)
    EXPECT_TRUE(manual->present(manualHeading(page, Item::Kind::none))) << pageKey(page);
  for (const auto kind : {Item::Kind::cut, Item::Kind::constraint, Item::Kind::velocity, Item::Kind::monitor})
    EXPECT_TRUE(manual->present(manualHeading(WorkflowPage::joints, kind)));
}

TEST_F(Access, TheCommandSearchFindsEveryCommandOfTheMenus) {
  window->activateWindow();
  QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
  rest(20);
  auto* search = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(search, nullptr);
  EXPECT_EQ(search->accessibleName(), QStringLiteral("Find a command"));
  const bool dark = session->display.isDark();
  QTest::keyClicks(search, QStringLiteral("light or dark"));
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_NE(session->display.isDark(), dark);
  session->display.setDark(dark);
}

}  // namespace
}  // namespace talus
