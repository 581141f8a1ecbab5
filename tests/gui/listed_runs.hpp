#pragma once

#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <cstdlib>

#include "widgets/verification/run_list.hpp"

/// The parts of a list of runs, as a user finds them.
namespace talus {

/// The list of runs is the only table that lets several rows be selected.
inline PlainTable& listOf(const RunList& list) {
  const auto tables = list.findChildren<PlainTable*>();
  return **std::find_if(tables.begin(), tables.end(), [](const PlainTable* table) {
    return table->selectionMode() == QAbstractItemView::ExtendedSelection;
  });
}

inline QPushButton& button(const QWidget& widget, const char* words) {
  const auto buttons = widget.findChildren<QPushButton*>();
  return **std::find_if(buttons.begin(), buttons.end(),
                        [words](const QPushButton* one) { return one->text() == QLatin1String(words); });
}

inline void click(QPushButton& one) { QTest::mouseClick(&one, Qt::LeftButton); }

inline int rowOf(const PlainTable& list, const char* title) {
  for (int row = 0; row < list.rowCount(); ++row)
    if (list.item(row, 0)->text() == QLatin1String(title)) return row;
  return -1;
}

/// Where the pictures of a test go when someone wants to see them: TALUS_PICTURES names the folder.
inline void keepPicture(QWidget& widget, const char* name) {
  if (const char* pictures = std::getenv("TALUS_PICTURES"))
    widget.grab().save(QString::fromUtf8(pictures) + u'/' + QLatin1String(name));
}

}  // namespace talus
