#include "widgets/window/language_menu.hpp"

#include <QActionGroup>

#include "session/messages.hpp"
#include "widgets/kit/language.hpp"

namespace talus {

LanguageMenu::LanguageMenu(Messages& messages, QWidget* parent) : QMenu(tr("Language"), parent), messages_(messages) {
  setToolTipsVisible(true);
  auto* one = new QActionGroup(this);
  add(tr("As the system"), {});
  addSeparator();
  for (const auto& language : language::all()) add(language.name, language.code);
  for (QAction* action : actions())
    if (!action->isSeparator()) one->addAction(action);
}

void LanguageMenu::add(const QString& words, const QString& code) {
  QAction* action = addAction(words);
  action->setCheckable(true);
  action->setChecked(code == language::chosen());
  action->setToolTip(tr("Spoken from the next start of Talus on"));
  connect(action, &QAction::triggered, this, [this, words, code] {
    language::choose(code);
    messages_.add({Problem::Severity::info, tr("Language"), tr("%1 is chosen").arg(words),
                   tr("it is spoken from the next start of Talus on")});
  });
}

}  // namespace talus
