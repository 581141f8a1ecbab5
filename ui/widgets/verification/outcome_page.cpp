#include "widgets/verification/outcome_page.hpp"

namespace talus {

OutcomePage::OutcomePage() : title_(makeLabel({}, "title")), verdict_(makeLabel({}, "chip")) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* head = makePlane("header");
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(12, 6, 12, 6);
  row->setSpacing(8);
  title_->setWordWrap(true);
  row->addWidget(title_, 1);
  row->addWidget(verdict_, 0, Qt::AlignVCenter);
  column->addWidget(head);
  auto* inner = makePlane("surface");
  content_ = new QVBoxLayout(inner);
  content_->setContentsMargins(12, 8, 12, 12);
  content_->setSpacing(8);
  column->addWidget(makeScrolled(inner), 1);
}

void OutcomePage::begin(const QString& title, const char* chip, const QString& verdict) {
  title_->setText(title);
  setRole(verdict_, chip);
  verdict_->setText(verdict);
  clearLayout(*content_);
}

void OutcomePage::addSentence(const QString& words, const char* role) {
  auto* label = makeWrappedLabel(words, role);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  content_->addWidget(label);
}

}  // namespace talus
