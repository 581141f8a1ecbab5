#include "widgets/results/explained_panel.hpp"

#include "widgets/kit/parts.hpp"

namespace talus {

ExplainedPanel::ExplainedPanel(QWidget* content) : content_(content), sentence_(makeWrappedLabel({}, "muted")) {
  setProperty("plane", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  sentence_->setAlignment(Qt::AlignCenter);
  column->addWidget(sentence_, 1);
  column->addWidget(content_, 1);
}

void ExplainedPanel::explain(const QString& why) {
  sentence_->setText(why);
  sentence_->setVisible(!why.isEmpty());
  content_->setVisible(why.isEmpty());
}

}  // namespace talus
