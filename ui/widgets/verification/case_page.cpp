#include "widgets/verification/case_page.hpp"

#include <QHeaderView>
#include <cmath>

#include "widgets/kit/numbers.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int most_case_rows = 14;  // of a table before it scrolls by itself
constexpr int figures = 7;

/// Error and tolerance: relative as they are, absolute with ± before them.
QString margin(const Finding& finding, double number) {
  return finding.absolute && std::isfinite(number) ? QChar(0xb1) + numbers::figure(number, 2)
                                                   : numbers::figure(number, 2);
}

QStringList cellsOf(const Finding& finding) {
  return {numbers::inSentence(finding.quantity),
          text(finding.unit),
          numbers::figure(finding.expected, figures),
          numbers::figure(finding.computed, figures),
          margin(finding, finding.error()),
          finding.reported ? QStringLiteral("–") : margin(finding, finding.tolerance),
          finding.reported   ? QObject::tr("shown")
          : finding.passed() ? QObject::tr("yes")
                             : QObject::tr("no")};
}

QString sentenceOf(const Repetition& repetition) {
  const QString which =
      QObject::tr("%1 at scale %2")
          .arg(numbers::counted(repetition.options.threads, "thread"), numbers::figure(repetition.options.scale, 3));
  if (!repetition.failure.empty())
    return QObject::tr("%1: failed, %2").arg(which, numbers::inSentence(repetition.failure));
  if (repetition.same_bits) return QObject::tr("%1: the same bits").arg(which);
  QString sentence = QObject::tr("%1: relative difference %2").arg(which, numbers::figure(repetition.largest.value, 2));
  if (!repetition.largest.quantity.empty())
    sentence += QStringLiteral(" (%1)").arg(numbers::inSentence(repetition.largest.quantity));
  if (repetition.about_zero.quantity.empty()) return sentence;
  return sentence +
         QObject::tr("; about zero %1 of the tolerance (%2)")
             .arg(numbers::figure(repetition.about_zero.value, 2), numbers::inSentence(repetition.about_zero.quantity));
}

}  // namespace

void CasePage::show(const KnownCase& known, const CaseResult* result) {
  if (!result)
    begin(numbers::inSentence(known.title), "chip", tr("not run yet"));
  else
    begin(numbers::inSentence(known.title), result->passed() ? "chipOk" : "chipError",
          (result->passed() ? tr("passed in %1") : tr("failed in %1")).arg(numbers::duration(result->seconds)));
  addSentence(tr("Source: %1").arg(text(known.source)), "muted");
  if (result) {
    if (!result->failure.empty())
      addSentence(tr("Came to no answer: %1").arg(numbers::inSentence(result->failure)), "error");
    if (!result->outcome.findings.empty()) addFindings(*result);
    addSentences(*result);
    for (const CaseTable& table : result->outcome.tables) addTable(table);
  } else if (known.takes_long) {
    addSentence(tr("This case takes minutes."), "muted");
  }
  content().addStretch();
}

void CasePage::addFindings(const CaseResult& result) {
  auto* table = new PlainTable;
  table->setObjectName(QStringLiteral("findings"));
  std::vector<QStringList> rows;
  for (const Finding& finding : result.outcome.findings) rows.push_back(cellsOf(finding));
  table->setContent(
      {tr("Quantity"), tr("Unit"), tr("Expected"), tr("Computed"), tr("Error"), tr("Tolerance"), tr("Passed")}, rows,
      {true, true, false, false, false, false, true});
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int row = 0; row < table->rowCount(); ++row) {
    const Finding& finding = result.outcome.findings[static_cast<size_t>(row)];
    table->item(row, 0)->setToolTip(numbers::inSentence(finding.quantity));
    if (finding.reported) continue;
    table->item(row, 6)->setIcon(finding.passed() ? theme::icon(QStringLiteral("ok"), theme::Tone::ok)
                                                  : theme::icon(QStringLiteral("error"), theme::Tone::error));
  }
  table->wrapWords(most_case_rows);
  table->fitHeight(most_case_rows);
  content().addWidget(table);
  addSentence(tr("Error and tolerance are relative to the expected number; with ± they are in its unit."), "faint");
}

void CasePage::addSentences(const CaseResult& result) {
  for (const Repetition& repetition : result.repetitions)
    addSentence(sentenceOf(repetition), repetition.passed ? nullptr : "error");
  for (const std::string& remark : result.outcome.remarks) addSentence(numbers::inSentence(remark));
}

void CasePage::addTable(const CaseTable& shown) {
  content().addWidget(makeLabel(numbers::inSentence(shown.title), "section"));
  auto* table = new PlainTable;
  QStringList heads;
  std::vector<bool> words;
  for (std::size_t column = 0; column < shown.columns.size(); ++column) {
    heads << numbers::inSentence(shown.columns[column]);
    words.push_back(shown.holds_words(column));
  }
  std::vector<QStringList> rows;
  for (const auto& cells : shown.rows) {
    QStringList row;
    for (const std::string& cell : cells) row << numbers::inSentence(cell);
    rows.push_back(row);
  }
  table->setContent(heads, rows, words);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->fitHeight(most_case_rows);
  content().addWidget(table);
}

}  // namespace talus
