#include "widgets/results/range_fields.hpp"

#include <QVBoxLayout>

#include "widgets/kit/number_field.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

RangeFields::RangeFields(const QString& what) : what_(what) { setMargins(new QVBoxLayout(this), 0, 3); }

void RangeFields::show(const ValueRange& range, const QString& unit) {
  range_ = range;
  const double ends[] = {range.low, range.high};
  for (std::size_t end = 0; end < 2; ++end) {
    NumberField*& number = numbers_[end];
    if (number && unit != unit_) {
      delete number;
      number = nullptr;
    }
    if (!number) {
      number = new NumberField(ends[end], {unit, unit});
      number->setAccessibleName(end == 0 ? tr("%1, lowest").arg(what_) : tr("%1, highest").arg(what_));
      number->setMeaning(number->accessibleName());
      connect(number, &NumberField::committed, this, [this, end](double value) { take(end, value); });
      layout()->addWidget(number);
    }
    number->setValue(ends[end]);
  }
  unit_ = unit;
}

void RangeFields::take(std::size_t end, double value) {
  ValueRange range = range_;
  (end == 0 ? range.low : range.high) = value;
  if (range.low < range.high)
    emit typed(range);
  else
    numbers_[end]->setProblem(tr("The lowest value must be below the highest"));
}

}  // namespace talus
