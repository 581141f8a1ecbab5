#include "widgets/window/top_bar.hpp"

#include <QAbstractItemView>
#include <QCompleter>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>
#include <QTimer>
#include <QToolButton>

#include "document/document.hpp"
#include "session/display.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

QToolButton* makeActionButton(QAction* action, bool worded) {
  auto* button = worded ? makeAction({}, action->text()) : makeTool({}, action->text());
  auto follow = [button, action, worded] {
    button->setIcon(action->icon());
    button->setEnabled(action->isEnabled());
    button->setToolTip(action->toolTip());
    if (worded) button->setText(QStringLiteral(" ") + action->text().remove(u'…'));
  };
  QObject::connect(action, &QAction::changed, button, follow);
  QObject::connect(button, &QToolButton::clicked, action, &QAction::trigger);
  follow();
  return button;
}

TopBar::TopBar(Document& document, Display& display, WindowActions& actions)
    : document_(document), display_(display), actions_(actions) {
  setProperty("plane", "top");
  setFixedHeight(theme::now().metrics.bar);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 0, 8, 0);
  row->setSpacing(2);
  row->addWidget(new Glyph(QStringLiteral("logo"), theme::Tone::accent, 22));
  row->addSpacing(4);
  auto* menus = new QMenuBar;
  menus->setNativeMenuBar(false);
  recent_ = new QMenu(tr("Recent"), this);
  actions_.fill(*menus, recent_);
  menus->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  menus->setFixedWidth(372);
  row->addWidget(menus);
  row->addStretch();
  name_ = new ElidedLabel({}, "strong");
  saved_ = makeLabel({}, "small");
  row->addWidget(name_);
  row->addSpacing(6);
  row->addWidget(saved_);
  row->addStretch();
  row->addWidget(makeActionButton(actions_.undo, false));
  row->addWidget(makeActionButton(actions_.redo, false));
  row->addSpacing(6);
  search_ = makeSearch();
  row->addWidget(search_);
  row->addSpacing(6);
  theme_ = makeTool(QStringLiteral("moon"), tr("Light or dark (Ctrl+Shift+D)"));
  connect(theme_, &QToolButton::clicked, actions_.dark, &QAction::trigger);
  row->addWidget(theme_);
  connect(&display_, &Display::themeChanged, this, &TopBar::refresh);
  connect(&document_, &Document::savedChanged, this, &TopBar::refresh);
  refresh();
}

QLineEdit* TopBar::makeSearch() {
  auto* edit = new QLineEdit;
  edit->setProperty("kind", "search");
  edit->setPlaceholderText(tr("Find a command   Ctrl+K"));
  edit->setAccessibleName(tr("Find a command"));
  edit->addAction(theme::icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  edit->setFixedWidth(208);
  edit->setFocusPolicy(Qt::ClickFocus);
  QStringList names;
  for (auto* action : actions_.all()) names << action->text().remove(u'…');
  auto* completer = new QCompleter(names, edit);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  completer->setFilterMode(Qt::MatchContains);
  completer->popup()->setTextElideMode(Qt::ElideRight);
  edit->setCompleter(completer);
  connect(completer, qOverload<const QString&>(&QCompleter::activated), this, &TopBar::runCommand);
  connect(edit, &QLineEdit::returnPressed, this, [this] { runCommand(search_->text()); });
  return edit;
}

void TopBar::focusSearch() { search_->setFocus(Qt::ShortcutFocusReason); }

void TopBar::runCommand(const QString& name) {
  if (name.isEmpty()) return;
  for (auto* action : actions_.all()) {
    if (action->text().remove(u'…').compare(name, Qt::CaseInsensitive) != 0) continue;
    QTimer::singleShot(0, search_, &QLineEdit::clear);  // the completer writes its choice after this
    search_->clearFocus();
    action->trigger();
    return;
  }
}

void TopBar::refresh() {
  name_->setText(document_.isOpen() ? document_.name() : QString());
  saved_->setText(!document_.isOpen()        ? QString()
                  : document_.file().empty() ? (document_.isSaved() ? tr("has no file") : tr("not saved"))
                  : document_.isSaved()      ? tr("saved")
                                             : tr("edited"));
  theme_->setIcon(theme::icon(display_.isDark() ? QStringLiteral("sun") : QStringLiteral("moon")));
}

}  // namespace talus
