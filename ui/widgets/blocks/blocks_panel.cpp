#include "widgets/blocks/blocks_panel.hpp"

#include <QLineEdit>
#include <QMenu>

#include "base/error.hpp"
#include "session/block_edits.hpp"
#include "session/block_survey.hpp"
#include "session/current_project.hpp"
#include "session/messages.hpp"
#include "widgets/blocks/block_columns.hpp"
#include "widgets/blocks/block_table.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int leaving_column = 8;  // how a block leaves its place: the longest words
constexpr int search_width = 200;
constexpr std::size_t most_entries = 30;  // of a menu

}  // namespace

BlocksPanel::BlocksPanel(CurrentProject& project, BlockSurvey& survey, Messages& messages,
                         const QList<QToolButton*>& tools)
    : project_(project), survey_(survey), messages_(messages), table_(new BlockTable(project)), words_(new QLineEdit) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* head = makePlane("header");
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(12, 3, 12, 3);
  row->setSpacing(4);
  words_->setPlaceholderText(tr("Look for blocks"));
  words_->setAccessibleName(tr("Look for blocks"));
  words_->setToolTip(tr("Shows the rows that have these letters in one of their words"));
  words_->setClearButtonEnabled(true);
  words_->setProperty("kind", "search");
  words_->setFixedWidth(search_width);
  row->addWidget(words_);
  row->addSpacing(8);
  for (auto* tool : tools) row->addWidget(tool);
  row->addStretch();
  excavated_ = makeAction(QStringLiteral("eye-off"), {}, tr("Blocks that are left out; each can be brought back"));
  excavated_->setObjectName(QStringLiteral("excavated"));
  excavated_->setPopupMode(QToolButton::InstantPopup);
  excavated_->setMenu(new QMenu(excavated_));
  row->addWidget(excavated_);
  column->addWidget(head);
  table_->setObjectName(QStringLiteral("blocks"));
  table_->setAccessibleName(tr("Blocks"));
  column->addWidget(table_, 1);
  connect(words_, &QLineEdit::textChanged, table_, &BlockTable::lookFor);
  connect(&survey_, &BlockSurvey::changed, this, &BlocksPanel::refresh);  // comes with other blocks, too
  connect(&project_.document(), &Document::projectChanged, this, [this] {
    emit titleChanged(title());
    refreshExcavated();
  });
  connect(&project_, &CurrentProject::opened, this, &BlocksPanel::refreshExcavated);
  connect(excavated_->menu(), &QMenu::triggered, this, [this](const QAction* action) {
    std::vector<std::string> names{action->data().toString().toStdString()};
    if (names.front().empty()) names = block_edits::excavated(project_);
    try {
      block_edits::bringBack(project_, names);
    } catch (const InputError& error) {
      messages_.add(problemOf(error));
    }
  });
  refresh();
  refreshExcavated();
}

QString BlocksPanel::title() const {
  return project_.system() && !project_.systemIsCurrent() ? tr("Blocks, before the last change") : tr("Blocks");
}

void BlocksPanel::showEvent(QShowEvent* event) {
  survey_.want();
  refresh();
  QWidget::showEvent(event);
}

void BlocksPanel::refresh() {
  emit titleChanged(title());
  if (!isVisible()) return;
  table_->setEmptyWords(!project_.system()         ? tr("Not cut yet.")
                        : words_->text().isEmpty() ? tr("No block was left.")
                                                   : tr("No block is like this."));
  std::vector<BlockColumn> columns;
  if (project_.system()) columns = blockColumns(project_.system(), project_.builtFrom(), survey_.facts());
  table_->setContent(std::move(columns), leaving_column);
}

void BlocksPanel::refreshExcavated() {
  const auto names = block_edits::excavated(project_);
  excavated_->setVisible(!names.empty());
  excavated_->setText(u' ' + tr("%1 excavated").arg(names.size()));
  QMenu& menu = *excavated_->menu();
  menu.clear();
  menu.addAction(tr("Bring all back"))->setData(QString());
  menu.addSeparator();
  for (std::size_t i = 0; i < std::min(names.size(), most_entries); ++i)
    menu.addAction(tr("Bring back %1").arg(text(names[i])))->setData(text(names[i]));
}

}  // namespace talus
