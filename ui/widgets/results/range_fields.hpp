#pragma once

#include <QWidget>
#include <array>

#include "render/paint/value_range.hpp"

namespace talus {

class NumberField;

/// The two ends of a range, to be typed: the lowest above the highest.
class RangeFields : public QWidget {
  Q_OBJECT
 public:
  /// `what`: what they are the ends of, for those who hear the window.
  explicit RangeFields(const QString& what);
  /// In the unit, in which numbers come back as well.
  void show(const ValueRange& range, const QString& unit);

 signals:
  /// The lowest is below the highest.
  void typed(const talus::ValueRange& range);

 private:
  void take(std::size_t end, double value);

  QString what_, unit_;
  ValueRange range_;
  std::array<NumberField*, 2> numbers_{};
};

}  // namespace talus
