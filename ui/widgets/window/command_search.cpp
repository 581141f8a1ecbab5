#include "widgets/window/command_search.hpp"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QCompleter>
#include <QDockWidget>
#include <QMenu>
#include <QStandardItemModel>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>

#include "widgets/kit/theme.hpp"

namespace talus {

namespace {

constexpr int command_search_width = 208, most_shown = 12;

QString plain(QString words) { return words.remove(u'…').remove(u'&').trimmed(); }

bool isInForm(const QWidget& widget) {
  for (const QWidget* around = &widget; around; around = around->parentWidget())
    if (around->inherits("talus::FormField")) return true;
  return false;
}

/// Entries that Qt makes of itself: of docks and bars, of the entries that edit text.
bool isOwnOfQt(const QAction& action) {
  return qobject_cast<QDockWidget*>(action.parent()) || qobject_cast<QToolBar*>(action.parent()) ||
         qobject_cast<QLineEdit*>(action.parent());
}

void add(std::vector<Command>& commands, QAction* action) {
  if (action->isSeparator() || action->menu() || isOwnOfQt(*action) || plain(action->text()).isEmpty()) return;
  const auto* menu = qobject_cast<const QMenu*>(action->parent());
  const QString before = menu && !menu->title().isEmpty() ? menu->title() + QStringLiteral(": ") : QString();
  commands.push_back({before + plain(action->text()), action->shortcut().toString(QKeySequence::NativeText),
                      action->isEnabled(), action->toolTip(), [kept = QPointer(action)] {
                        if (kept) kept->trigger();
                      }});
}

void add(std::vector<Command>& commands, QAbstractButton* button) {
  const auto* tool = qobject_cast<const QToolButton*>(button);
  if (!button->isVisible() || isInForm(*button) || (tool && tool->menu())) return;
  QString words = plain(button->text());
  if (words.isEmpty()) words = plain(button->accessibleName().section(u'\n', 0, 0));
  const bool known = std::ranges::any_of(
      commands, [&](const Command& one) { return one.words.compare(words, Qt::CaseInsensitive) == 0; });
  if (words.isEmpty() || known) return;
  commands.push_back({words, {}, button->isEnabled(), button->toolTip(), [kept = QPointer(button)] {
                        if (kept) kept->click();
                      }});
}

QString lineOf(const Command& command) {
  return command.key.isEmpty() ? command.words : command.words + QStringLiteral("   ") + command.key;
}

}  // namespace

std::vector<Command> commandsOf(const QWidget& window) {
  std::vector<Command> commands;
  for (QAction* action : window.findChildren<QAction*>()) add(commands, action);
  for (QAbstractButton* button : window.findChildren<QAbstractButton*>()) add(commands, button);
  return commands;
}

CommandSearch::CommandSearch() {
  setProperty("kind", "search");
  setPlaceholderText(tr("Find a command   Ctrl+K"));
  setAccessibleName(tr("Find a command"));
  setToolTip(tr("Any command of the menus and buttons, by some letters of its name (Ctrl+K)"));
  addAction(theme::icon(QStringLiteral("search")), LeadingPosition);
  setFixedWidth(command_search_width);
  setFocusPolicy(Qt::ClickFocus);
  auto* completer = new QCompleter(new QStandardItemModel, this);
  completer->model()->setParent(completer);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  completer->setFilterMode(Qt::MatchContains);
  completer->setMaxVisibleItems(most_shown);
  completer->popup()->setTextElideMode(Qt::ElideRight);
  setCompleter(completer);
  connect(completer, qOverload<const QString&>(&QCompleter::activated), this, &CommandSearch::run);
  connect(this, &QLineEdit::returnPressed, this, [this] {
    if (!text().isEmpty()) run(text());
  });
}

void CommandSearch::begin() {
  commands_ = commandsOf(*window());
  auto& model = *static_cast<QStandardItemModel*>(completer()->model());
  model.clear();
  for (const Command& command : commands_) {
    if (!model.findItems(lineOf(command)).isEmpty()) continue;
    auto* line = new QStandardItem(lineOf(command));
    if (!command.isPossible) line->setForeground(disabledText(theme::colours()));
    line->setToolTip(command.why);
    model.appendRow(line);
  }
  setFocus(Qt::ShortcutFocusReason);
  selectAll();
}

void CommandSearch::run(const QString& line) {
  const auto says = [&](const Command& one) {
    return lineOf(one).compare(line, Qt::CaseInsensitive) == 0 || one.words.compare(line, Qt::CaseInsensitive) == 0;
  };
  auto found = std::ranges::find_if(commands_, says);
  if (found == commands_.end())
    found = std::ranges::find_if(commands_,
                                 [&](const Command& one) { return one.words.contains(line, Qt::CaseInsensitive); });
  if (found == commands_.end()) return;
  if (!found->isPossible) {
    QToolTip::showText(mapToGlobal(QPoint(0, height())), found->why, this);
    return;
  }
  const auto act = found->run;                     // what it does may look for commands anew
  QTimer::singleShot(0, this, &QLineEdit::clear);  // the completer writes its choice after this
  clearFocus();
  act();
}

}  // namespace talus
