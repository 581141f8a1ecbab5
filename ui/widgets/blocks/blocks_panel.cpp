#include "widgets/blocks/blocks_panel.hpp"

#include <Eigen/Geometry>
#include <QLineEdit>
#include <QMenu>

#include "base/error.hpp"
#include "session/block_edits.hpp"
#include "session/session.hpp"
#include "widgets/blocks/block_columns.hpp"
#include "widgets/blocks/block_table.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int search_width = 200;
constexpr std::size_t most_entries = 30;  // of a menu

}  // namespace

BlocksPanel::BlocksPanel(Session& session, const QList<QToolButton*>& tools, const QList<QAction*>& menu)
    : session_(session), table_(new BlockTable(session.project)), words_(new QLineEdit) {
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
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  table_->addActions(menu);
  column->addWidget(table_, 1);
  connect(table_, &BlockTable::blockWanted, this, &BlocksPanel::goTo);
  connect(words_, &QLineEdit::textChanged, table_, &BlockTable::lookFor);
  connect(&session_.survey, &BlockSurvey::changed, this, &BlocksPanel::refresh);  // comes with other blocks, too
  connect(&session_.project.document(), &Document::projectChanged, this, [this] {
    emit titleChanged(title());
    refreshExcavated();
  });
  connect(&session_.project, &CurrentProject::opened, this, &BlocksPanel::refreshExcavated);
  connect(excavated_->menu(), &QMenu::triggered, this, [this](const QAction* action) {
    std::vector<std::string> names{action->data().toString().toStdString()};
    if (names.front().empty()) names = block_edits::excavated(session_.project);
    try {
      block_edits::bringBack(session_.project, names);
    } catch (const InputError& error) {
      session_.messages.add(problemOf(error));
    }
  });
  refresh();
  refreshExcavated();
}

QString BlocksPanel::title() const {
  return session_.project.system() && !session_.project.systemIsCurrent() ? tr("Blocks, before the last change")
                                                                          : tr("Blocks");
}

void BlocksPanel::showEvent(QShowEvent* event) {
  session_.survey.want();
  refresh();
  QWidget::showEvent(event);
}

void BlocksPanel::refresh() {
  emit titleChanged(title());
  if (!isVisible()) return;
  table_->setEmptyWords(!session_.project.system() ? tr("Not cut yet.")
                        : words_->text().isEmpty() ? tr("No block was left.")
                                                   : tr("No block is like this."));
  std::vector<BlockColumn> columns;
  if (session_.project.system())
    columns = blockColumns(session_.project.system(), session_.project.builtFrom(), session_.survey.facts());
  table_->setContent(std::move(columns));
}

void BlocksPanel::goTo(int block) {
  const Block& one = session_.project.system()->blocks.at(static_cast<std::size_t>(block));
  Eigen::AlignedBox3d box;
  for (const Vec3& node : one.mesh.nodes) box.extend(node);
  session_.display.showPlace({box.center(), box.diagonal().norm(), {}});
}

void BlocksPanel::refreshExcavated() {
  const auto names = block_edits::excavated(session_.project);
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
