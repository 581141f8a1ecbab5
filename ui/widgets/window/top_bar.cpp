#include "widgets/window/top_bar.hpp"

#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>

#include "document/document.hpp"
#include "session/display.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/window/command_search.hpp"

namespace talus {

QToolButton* makeActionButton(QAction* action, bool worded) {
  auto* button = worded ? makeAction({}, action->text()) : makeTool({}, action->text());
  auto follow = [button, action, worded] {
    button->setIcon(action->icon());
    button->setEnabled(action->isEnabled());
    button->setCheckable(action->isCheckable());
    button->setChecked(action->isChecked());
    button->setToolTip(action->toolTip());
    if (worded) button->setText(QStringLiteral(" ") + action->text().remove(u'…'));
  };
  QObject::connect(action, &QAction::changed, button, follow);
  QObject::connect(button, &QToolButton::clicked, action, &QAction::trigger);
  follow();
  return button;
}

namespace {

/// A menu bar asks for less than its titles need before it is shown.
int widthOf(const QMenuBar& menus) {
  constexpr int around_a_title = 24;  // pixels
  const QFontMetrics metrics(theme::font(theme::now().type.body));
  int width = 0;
  for (const QAction* title : menus.actions()) width += metrics.horizontalAdvance(title->text()) + around_a_title;
  return width;
}

}  // namespace

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
  menus->setFixedWidth(widthOf(*menus));
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
  search_ = new CommandSearch;
  row->addWidget(search_);
  row->addSpacing(6);
  theme_ = makeTool(QStringLiteral("moon"), tr("Light or dark (Ctrl+Shift+D)"));
  connect(theme_, &QToolButton::clicked, actions_.dark, &QAction::trigger);
  row->addWidget(theme_);
  connect(&display_, &Display::themeChanged, this, &TopBar::refresh);
  connect(&document_, &Document::savedChanged, this, &TopBar::refresh);
  refresh();
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
