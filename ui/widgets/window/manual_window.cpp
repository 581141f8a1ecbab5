#include "widgets/window/manual_window.hpp"

#include <QFile>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QVBoxLayout>
#include <array>

#include "widgets/kit/parts.hpp"

namespace talus {

namespace {

/// Room around headings and paragraphs, and tables with thin lines: Markdown has no style sheet.
void spaceOut(QTextDocument& document) {
  constexpr int above_heading = 20, below = 6, cell_padding = 5;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    QTextBlockFormat format = block.blockFormat();
    if (QTextCursor(block).currentTable()) continue;
    if (format.headingLevel() > 0) format.setTopMargin(above_heading);
    format.setBottomMargin(below);
    QTextCursor(block).setBlockFormat(format);
  }
  for (QTextFrame* frame : document.rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (!table) continue;
    QTextTableFormat format = table->format();
    format.setCellPadding(cell_padding);
    format.setCellSpacing(0);
    format.setBorderCollapse(true);
    format.setBorder(1);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(theme::colours().border);
    format.setBottomMargin(2 * below);
    table->setFormat(format);
  }
}

}  // namespace

QString manualHeading(WorkflowPage page, Item::Kind selected) {
  switch (selected) {
    case Item::Kind::cut:
      return QStringLiteral("Cuts");
    case Item::Kind::constraint:
      return QStringLiteral("Constraints");
    case Item::Kind::velocity:
      return QStringLiteral("Velocities");
    case Item::Kind::monitor:
      return QStringLiteral("Monitors");
    default:
      break;
  }
  constexpr std::array headings{"Solids",
                                "Joints",
                                "Blocks and mesh in the window",
                                "Blocks and mesh in the window",
                                "Materials",
                                "Loads",
                                "Stages",
                                "What a run costs",
                                "Results"};
  return QLatin1String(headings.at(static_cast<std::size_t>(page)));
}

ManualWindow::ManualWindow(QWidget* parent) : QDialog(parent), pages_(new QTextBrowser) {
  setWindowTitle(tr("Manual"));
  resize(760, 680);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  pages_->setAccessibleName(tr("Manual"));
  pages_->setFrameShape(QFrame::NoFrame);
  pages_->document()->setDocumentMargin(20);
  pages_->setOpenLinks(false);
  column->addWidget(pages_);
  QFile file(QStringLiteral(":/manual.md"));
  if (file.open(QIODevice::ReadOnly)) pages_->setMarkdown(QString::fromUtf8(file.readAll()));
  spaceOut(*pages_->document());
}

bool ManualWindow::present(const QString& heading) {
  show();
  raise();
  activateWindow();
  for (QTextBlock block = pages_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || block.text() != heading) continue;
    QTextCursor cursor(block);
    pages_->setTextCursor(cursor);
    pages_->verticalScrollBar()->setValue(pages_->verticalScrollBar()->value() + pages_->cursorRect(cursor).top() - 12);
    return true;
  }
  return false;
}

}  // namespace talus
