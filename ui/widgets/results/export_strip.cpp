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
  bar_->setAccessibleName(tr("Share of what is written"));
  auto* cancel = makeButton(tr("Cancel"), "link");
  cancel->setFocusPolicy(Qt::TabFocus);  // the view keeps the keys when it is clicked
  row->addWidget(cancel);
  connect(cancel, &QPushButton::clicked, &job, &ExportJob::cancel);
  connect(&job, &ExportJob::progressed, this, [this](double fraction) { showShare(*bar_, fraction); });
  connect(&job, &ExportJob::started, this, [this](const QString& what) {
    name_ = what;
    bar_->setValue(0);
  });
  connect(&job, &ExportJob::waitingChanged, this,
          [this](int count) { what_->setText(count == 0 ? name_ : tr("%1, %2 more to write").arg(name_).arg(count)); });
  connect(&job, &ExportJob::busyChanged, this, &QWidget::setVisible);
  hide();
}

}  // namespace talus
