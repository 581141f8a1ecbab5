#include "widgets/window/manual_window.hpp"

#include <QFile>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QVBoxLayout>
#include <array>
#include <map>

#include "widgets/kit/parts.hpp"

namespace talus {

namespace {

const QSize manual_size(920, 720);

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
  static const std::map<Item::Kind, const char*> of_things{{Item::Kind::solid, "Solids"},
                                                           {Item::Kind::cut, "Cuts"},
                                                           {Item::Kind::joint, "Joints"},
                                                           {Item::Kind::block, "Blocks"},
                                                           {Item::Kind::blockWish, "Blocks"},
                                                           {Item::Kind::merge, "Blocks"},
                                                           {Item::Kind::splinters, "Blocks"},
                                                           {Item::Kind::mesh, "Mesh"},
                                                           {Item::Kind::interface, "Interfaces"},
                                                           {Item::Kind::material, "Materials"},
                                                           {Item::Kind::load, "Loads"},
                                                           {Item::Kind::constraint, "Constraints"},
                                                           {Item::Kind::velocity, "Velocities"},
                                                           {Item::Kind::inSitu, "Stress in situ"},
                                                           {Item::Kind::stage, "Stages"},
                                                           {Item::Kind::monitor, "Monitors"},
                                                           {Item::Kind::expectation, "Expectations"},
                                                           {Item::Kind::solver, "Solver"},
                                                           {Item::Kind::output, "Output"}};
  // On a page of results the block that is selected is looked at for how it moves.
  const bool sets_up = isSetUp(page) || selected != Item::Kind::block;
  if (const auto found = of_things.find(selected); found != of_things.end() && sets_up)
    return QLatin1String(found->second);
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
  resizeWithin(*this, manual_size);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  pages_->setAccessibleName(tr("Manual"));
  pages_->setFrameShape(QFrame::NoFrame);
  pages_->document()->setDocumentMargin(20);
  pages_->setOpenLinks(false);
  column->addWidget(pages_);
  QFile file(QStringLiteral(":/manual.md"));
  // Without its pictures: they show the window that this one stands beside.
  static const QRegularExpression picture(QStringLiteral("^!\\[[^\\n]*\\)\\n"), QRegularExpression::MultilineOption);
  if (file.open(QIODevice::ReadOnly)) pages_->setMarkdown(QString::fromUtf8(file.readAll()).remove(picture));
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
