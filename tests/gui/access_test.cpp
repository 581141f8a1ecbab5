// Everything that takes the keyboard has a name that a screen reader can say, and F1 leads to the manual.
#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <set>

#include "document/item_place.hpp"
#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "unit/io/sample_project.hpp"
#include "widgets/window/command_search.hpp"
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
  for (int kind = 0; kind <= static_cast<int>(Item::Kind::output); ++kind)
    for (const WorkflowPage page : all_pages) {
      const QString heading = manualHeading(page, static_cast<Item::Kind>(kind));
      EXPECT_TRUE(manual->present(heading)) << heading.toStdString();
    }
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

/// What the pointer is told over a widget: its own words, or those of what it lies in.
QString tipOf(const QWidget& widget) {
  for (const QWidget* around = &widget; around && !around->isWindow(); around = around->parentWidget())
    if (!around->toolTip().isEmpty()) return around->toolTip();
  return {};
}

bool isFieldOrButton(const QWidget& widget) {
  if (widget.objectName().startsWith(QStringLiteral("qt_"))) return false;
  for (const char* part : {"QScrollBar", "QLineEditIconButton", "CloseButton", "QTableCornerButton"})
    if (widget.inherits(part)) return false;
  return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
         qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractSlider*>(&widget);
}

/// A project that has every kind of thing, on every page with each of them selected.
class EveryForm : public DrivenWindow {
 protected:
  template <class Visit>
  void visitAll(Visit visit) {
    window->open(write("full.talus", test::full_project));
    ASSERT_TRUE(session->project.document().isOpen());
    for (const WorkflowPage page : all_pages) {
      session->display.goTo(page);
      session->project.selection().clear();
      rest(10);
      visit(pageKey(page));
    }
    session->display.goTo(WorkflowPage::loads);
    for (int kind = 1; kind <= static_cast<int>(Item::Kind::output); ++kind) {
      const Item item{static_cast<Item::Kind>(kind), 0};
      if (!listKey(item.kind) || !exists(item, session->project.document().json())) continue;
      session->project.selection().select(item);
      rest(10);
      visit(listKey(item.kind));
    }
  }
};

TEST_F(EveryForm, EveryFieldAndButtonSaysWhatItIsFor) {
  std::set<std::string> silent;
  int seen = 0;
  visitAll([&](const char* where) {
    for (const auto* widget : window->findChildren<QWidget*>()) {
      if (!widget->isVisible() || !isFieldOrButton(*widget) || widget->window() != window.get()) continue;
      ++seen;
      if (!tipOf(*widget).isEmpty()) continue;
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      silent.insert(std::string(where) + ": " + widget->metaObject()->className() + " " +
                    widget->objectName().toStdString() + " " + (button ? button->text().toStdString() : ""));
    }
  });
  EXPECT_THAT(silent, testing::IsEmpty());
  EXPECT_GT(seen, 500);
}

TEST_F(EveryForm, EveryWidgetOfEveryFormHasANameForScreenReaders) {
  std::set<std::string> nameless;
  visitAll([&](const char* where) {
    for (auto* widget : window->findChildren<QWidget*>())
      if (widget->isVisible() && widget->window() == window.get() && isInteractive(*widget) &&
          nameOf(*widget).trimmed().isEmpty())
        nameless.insert(std::string(where) + ": " + widget->metaObject()->className() + " " +
                        widget->objectName().toStdString());
  });
  EXPECT_THAT(nameless, testing::IsEmpty());
}

TEST_F(EveryForm, TabGoesThroughAFormFromTopToBottom) {
  window->open(slidingCube(40));
  session->display.goTo(WorkflowPage::joints);
  session->project.selection().select({Item::Kind::joint, 0});
  window->activateWindow();
  rest(20);
  auto* first = window->findChild<QLineEdit*>(QStringLiteral("/joints/J1#name"));
  ASSERT_NE(first, nullptr);
  first->setFocus();
  int height = first->mapTo(window.get(), QPoint()).y(), fields = 0;
  for (int presses = 0; presses < 12; ++presses) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    const QWidget* next = QApplication::focusWidget();
    if (!next || !next->objectName().startsWith(QStringLiteral("/joints/J1"))) break;
    const int now = next->mapTo(window.get(), QPoint()).y();
    EXPECT_GE(now, height - 4) << next->objectName().toStdString();
    height = now;
    ++fields;
  }
  EXPECT_GT(fields, 5);
}

/// The entries of a menu and of those in it.
void collect(const QMenu& menu, std::vector<QAction*>& entries) {
  for (QAction* action : menu.actions()) {
    if (action->menu())
      collect(*action->menu(), entries);
    else if (!action->isSeparator())
      entries.push_back(action);
  }
}

TEST_F(Access, EveryEntryAndEveryButtonOfEveryPageIsACommand) {
  openAndMesh(slidingCube(40));
  std::vector<QAction*> entries;
  for (QAction* title : window->findChild<QMenuBar*>()->actions()) collect(*title->menu(), entries);
  EXPECT_GT(entries.size(), 60u);
  const auto known = [&](const std::vector<Command>& commands, QString words) {
    words = words.remove(u'…').remove(u'&').trimmed();
    return std::ranges::any_of(commands, [&](const Command& one) { return one.words.endsWith(words); });
  };
  for (const WorkflowPage page : all_pages) {
    session->display.goTo(page);
    rest(20);
    const auto commands = commandsOf(*window);
    for (const QAction* entry : entries) EXPECT_TRUE(known(commands, entry->text())) << entry->text().toStdString();
    for (const auto* button : window->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || button->text().isEmpty() || button->inherits("QCheckBox")) continue;
      bool inForm = false;
      for (const QWidget* around = button; around; around = around->parentWidget())
        inForm = inForm || around->inherits("talus::FormField");
      const auto* tool = qobject_cast<const QToolButton*>(button);
      if (inForm || (tool && tool->menu())) continue;
      EXPECT_TRUE(known(commands, button->text())) << pageKey(page) << ": " << button->text().toStdString();
    }
  }
}

TEST_F(Access, ACommandThatCannotBeDoneNowSaysWhy) {
  window->activateWindow();
  QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
  rest(20);
  auto* search = window->findChild<CommandSearch*>();
  QTest::keyClicks(search, QStringLiteral("cut and mesh"));
  QTest::keyClick(search, Qt::Key_Return);
  rest(20);
  EXPECT_EQ(search->text(), QStringLiteral("cut and mesh")) << "it stays to be read";
}

}  // namespace
}  // namespace talus
