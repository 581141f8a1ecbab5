#pragma once

#include <QTableWidget>
#include <vector>

namespace talus {

/// A table to be read: rows without grid, words to the left, numbers to the right.
class PlainTable : public QTableWidget {
  Q_OBJECT
 public:
  PlainTable();
  /// `words`: whether a column holds words; the others hold numbers.
  void setContent(const QStringList& heads, const std::vector<QStringList>& rows, const std::vector<bool>& words);
  /// As high as its rows, at most `most` of them; it scrolls beyond.
  void fitHeight(int most);
  /// Breaks what the first column says into lines where it becomes narrow, and fits the height again.
  void wrapWords(int most);
};

}  // namespace talus
