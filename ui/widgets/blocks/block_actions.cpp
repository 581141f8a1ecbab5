#include "widgets/blocks/block_actions.hpp"

#include <QWidget>

#include "base/error.hpp"
#include "removability/block_rule.hpp"
#include "session/block_edits.hpp"
#include "widgets/blocks/rule_dialog.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {

BlockActions::BlockActions(Session& session, QWidget& window) : QObject(&window), session_(session), window_(window) {
  byRule = add(tr("Select by rule…"), QStringLiteral("filter"), QKeySequence(tr("Ctrl+F")), &BlockActions::showRule);
  everyOne =
      add(tr("Select all blocks"), QStringLiteral("select"), QKeySequence(tr("Ctrl+A")), &BlockActions::selectAll);
  others = add(tr("Select the other blocks"), QStringLiteral("loop"), QKeySequence(tr("Ctrl+I")),
               &BlockActions::selectOthers);
  neighbours = add(tr("Select neighbours, too"), QStringLiteral("plus-set"), QKeySequence(tr("Ctrl+G")),
                   &BlockActions::selectNeighbours);
  lasso = add(tr("Shift and drag draw a lasso"), QStringLiteral("scatter"), QKeySequence(Qt::Key_L), nullptr);
  lasso->setCheckable(true);
  excavate = add(tr("Excavate selected blocks"), {}, QKeySequence(Qt::Key_Delete), &BlockActions::excavateSelected);
  merge = add(tr("Merge selected blocks"), {}, QKeySequence(Qt::Key_M), &BlockActions::mergeSelected);
}

QAction* BlockActions::add(const QString& words, const QString& icon, const QKeySequence& key,
                           void (BlockActions::*act)()) {
  auto* action = new QAction(words, this);
  if (!icon.isEmpty()) action->setIcon(theme::icon(icon));
  action->setShortcut(key);
  if (act) connect(action, &QAction::triggered, this, act);
  return action;
}

QString BlockActions::whyNot(const QAction* action) const {
  if (!session_.project.system()) return tr("There are no blocks yet");
  const std::size_t selected = session_.project.selection().blocks().size();
  if (action == merge && selected < 2) return tr("Select two blocks or more");
  if ((action == neighbours || action == excavate) && selected == 0) return tr("Select a block first");
  if ((action == neighbours || action == merge) && !session_.survey.facts())
    return tr("Their neighbours are looked for on the page Blocks");
  return {};
}

int BlockActions::count() const { return static_cast<int>(session_.project.system()->blocks.size()); }

void BlockActions::showRule() {
  if (!rule_) rule_ = new RuleDialog(session_, &window_);
  rule_->present();
}

void BlockActions::selectAll() { session_.project.selection().selectBlocks(inverted({}, count())); }

void BlockActions::selectOthers() {
  Selection& selection = session_.project.selection();
  selection.selectBlocks(inverted(selection.blocks(), count()));
}

void BlockActions::selectNeighbours() {
  Selection& selection = session_.project.selection();
  selection.selectBlocks(grown(selection.blocks(), *session_.survey.facts()));
}

void BlockActions::excavateSelected() {
  try {
    block_edits::excavate(session_.project, session_.project.selection().blocks());
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

void BlockActions::mergeSelected() {
  try {
    block_edits::merge(session_.project, session_.project.selection().blocks(), *session_.survey.facts());
  } catch (const InputError& error) {
    session_.messages.add(problemOf(error));
  }
}

}  // namespace talus
