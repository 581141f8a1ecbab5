#include "widgets/results/export_strip.hpp"

#include <QLabel>
#include <QProgressBar>

#include "widgets/kit/parts.hpp"

namespace talus {

ExportStrip::ExportStrip(ExportJob& job) : what_(makeLabel({}, "small")), bar_(makeProgressBar()) {
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 8);
  row->addWidget(what_);
  bar_->setFixedWidth(120);
  row->addWidget(bar_);
  auto* cancel = makeButton(tr("Cancel"), "link");
  row->addWidget(cancel);
  connect(cancel, &QPushButton::clicked, &job, &ExportJob::cancel);
  connect(&job, &ExportJob::progressed, this, [this](double fraction) { showShare(*bar_, fraction); });
  connect(&job, &ExportJob::cancelledByUser, this, &QWidget::hide);
  connect(&job, &ExportJob::finished, this, &QWidget::hide);
  connect(&job, &ExportJob::failed, this, &QWidget::hide);
  hide();
}

void ExportStrip::begin(const QString& what) {
  what_->setText(what);
  bar_->setValue(0);
  show();
}

}  // namespace talus
