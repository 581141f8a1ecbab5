#include "widgets/blocks/rule_dialog.hpp"

#include <QComboBox>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

namespace {
constexpr int dialog_width = 330;
}

RuleDialog::RuleDialog(Session& session, QWidget* parent)
    : QDialog(parent), session_(session), form_(new RuleForm(session)) {
  setWindowTitle(tr("Select blocks by rule"));
  setFixedWidth(dialog_width);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* plane = makePlane("surface");
  auto* rows = new QVBoxLayout(plane);
  setMargins(rows, 12, 8);
  rows->addWidget(makeLabel(tr("Blocks that have, or are"), "section"));
  rows->addWidget(form_);
  rows->addWidget(makeLabel(tr("become"), "section"));
  how_ = makeCombo(
      {tr("the selection"), tr("part of the selection"), tr("no part of it any more"), tr("all that stays of it")},
      tr("What becomes of the selection"));
  how_->setObjectName(QStringLiteral("how"));
  rows->addWidget(how_);
  rows->addStretch();
  column->addWidget(plane, 1);
  auto* foot = makePlane("header");
  auto* buttons = new QHBoxLayout(foot);
  buttons->setContentsMargins(12, 8, 12, 8);
  count_ = makeWrappedLabel({}, "small");
  count_->setObjectName(QStringLiteral("count"));
  buttons->addWidget(count_, 1);
  auto* close = makeButton(tr("Close"));
  close->setAutoDefault(false);
  select_ = makeButton(tr("Select"), "primary");
  select_->setObjectName(QStringLiteral("select"));
  select_->setDefault(true);
  buttons->addWidget(close);
  buttons->addWidget(select_);
  column->addWidget(foot);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(select_, &QPushButton::clicked, this, &RuleDialog::select);
  connect(form_, &RuleForm::changed, this, &RuleDialog::refresh);
  connect(how_, &QComboBox::currentIndexChanged, this, &RuleDialog::refresh);
  connect(&session_.survey, &BlockSurvey::changed, this, [this] {
    if (isVisible()) form_->refresh();
  });
  connect(&session_.project.selection(), &Selection::changed, this, [this] {
    if (isVisible()) refresh();
  });
}

void RuleDialog::present() {
  session_.survey.want();
  form_->refresh();
  show();
  raise();
  activateWindow();
}

std::optional<std::vector<int>> RuleDialog::wouldBe() const {
  const auto system = session_.project.system();
  const auto facts = session_.survey.facts();
  const auto rule = form_->rule();
  if (!system || !facts || !rule) return std::nullopt;
  return combined(session_.project.selection().blocks(), blocks_by(*rule, *system, *facts),
                  static_cast<Combination>(how_->currentIndex()));
}

void RuleDialog::refresh() {
  const auto system = session_.project.system();
  const auto blocks = wouldBe();
  select_->setEnabled(blocks.has_value());
  if (blocks)
    count_->setText(
        tr("%1 of %2").arg(numbers::whole(blocks->size()), numbers::counted(system->blocks.size(), "block")));
  else
    count_->setText(!system                    ? tr("There are no blocks yet")
                    : !session_.survey.facts() ? tr("Looking at the blocks")
                                               : tr("Say what is looked for"));
}

void RuleDialog::select() {
  if (auto blocks = wouldBe()) session_.project.selection().selectBlocks(std::move(*blocks));
}

}  // namespace talus
