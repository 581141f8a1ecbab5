#include "report/table_layout.hpp"

#include <gmock/gmock.h>

namespace talus::report {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(TableLayout, GivesEachColumnWhatItAsksForWhereThereIsRoom) {
  EXPECT_THAT(column_widths({{10, 40}, {20, 50}}, 100), ElementsAre(DoubleEq(40), DoubleEq(50)));
}

TEST(TableLayout, LetsColumnsGiveInProportionToWhatCanBeBroken) {
  EXPECT_THAT(column_widths({{10, 10}, {20, 60}, {10, 90}}, 100),
              ElementsAre(DoubleEq(10), DoubleEq(40), DoubleEq(50)));
}

TEST(TableLayout, SqueezesWhatDoesNotFitAtAll) {
  EXPECT_THAT(column_widths({{100, 120}, {300, 400}}, 200), ElementsAre(DoubleEq(50), DoubleEq(150)));
}

}  // namespace
}  // namespace talus::report
