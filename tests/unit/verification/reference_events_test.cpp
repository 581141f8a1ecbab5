#include "verification/reference_events.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "base/temporary_folder.hpp"

namespace talus {
namespace {

/// Two monitors that leave t = 0 with 1 m/s² and 2 m/s² along y, a row every second.
std::vector<HistoryRow> two_sliders(int seconds) {
  std::vector<HistoryRow> history;
  for (int t = 0; t <= seconds; ++t) {
    const double s = t * t;
    history.push_back({static_cast<double>(t), 0, {{{0, s / 2, 0}, {0, 1.0 * t, 0}}, {{0, s, 0}, {0, 2.0 * t, 0}}}});
  }
  return history;
}

const std::vector<std::string> names{"A", "B"};

ReferenceEvent event(double time, const char* quantity, double reaches, const char* minus = nullptr) {
  ReferenceEvent e{time, quantity, *parse_quantity(quantity), std::nullopt, reaches, ""};
  if (minus != nullptr) e.minus = parse_quantity(minus);
  return e;
}

TEST(ReferenceEvents, FindsTheMomentBetweenTwoRows) {
  const std::vector<ReferenceEvent> events{event(3, "A.displacement.y", 3.25)};  // 2 at t = 2, 4.5 at t = 3
  const auto comparison = compare_events(events, names, two_sliders(4));
  ASSERT_TRUE(comparison[0].computed);
  EXPECT_DOUBLE_EQ(*comparison[0].computed, 2.5);
  EXPECT_DOUBLE_EQ(*comparison[0].value_then, 4.5);
}

TEST(ReferenceEvents, TakesTheDifferenceOfTwoMonitors) {
  const std::vector<ReferenceEvent> events{event(3.5, "B.displacement.y", 4.5, "A.displacement.y")};
  const auto comparison = compare_events(events, names, two_sliders(4));
  EXPECT_DOUBLE_EQ(*comparison[0].computed, 3);
  EXPECT_DOUBLE_EQ(*comparison[0].value_then, (4.5 + 8) / 2);
}

TEST(ReferenceEvents, StressIsAQuantityToo) {
  auto history = two_sliders(2);
  for (HistoryRow& row : history) row.monitors[1].stress = Voigt::Constant(1e5 * row.time);
  const std::vector<ReferenceEvent> events{event(1, "B.stress.yz", 5e4)};
  const auto comparison = compare_events(events, names, history);
  ASSERT_TRUE(comparison[0].computed);
  EXPECT_DOUBLE_EQ(*comparison[0].computed, 0.5);
  EXPECT_DOUBLE_EQ(*comparison[0].value_then, 1e5);
}

TEST(ReferenceEvents, SaysWhatDidNotHappen) {
  const std::vector<ReferenceEvent> events{event(9, "B.velocity.magnitude", 100)};
  const auto comparison = compare_events(events, names, two_sliders(4));
  EXPECT_FALSE(comparison[0].computed);
  EXPECT_FALSE(comparison[0].value_then) << "the history ends at 4 s";
  EXPECT_FALSE(in_published_order(comparison));
}

TEST(ReferenceEvents, TheOrderCountsNotTheTimes) {
  const auto history = two_sliders(6);
  const std::vector<ReferenceEvent> right{event(1, "A.displacement.y", 2), event(5, "B.displacement.y", 9)};
  EXPECT_TRUE(in_published_order(compare_events(right, names, history)));
  const std::vector<ReferenceEvent> wrong{event(1, "B.displacement.y", 9), event(5, "A.displacement.y", 2)};
  EXPECT_FALSE(in_published_order(compare_events(wrong, names, history)));
}

TEST(ReferenceEvents, AnUnknownMonitorIsAnInputError) {
  const std::vector<ReferenceEvent> events{event(1, "C.displacement.y", 2)};
  EXPECT_THROW(compare_events(events, names, two_sliders(2)), InputError);
}

class EventFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    const auto file = folder_.path() / "events.csv";
    std::ofstream(file) << text;
    return file;
  }
  TemporaryFolder folder_;
};

TEST_F(EventFile, IsReadInTheOrderOfTime) {
  const auto events = read_reference_events(
      write("# a publication\ntime,event,quantity,minus,reaches\n"
            "49,J5 opens,B3.displacement.y,B2.displacement.y,5\r\n45,B2 leaves B1,B2.velocity.magnitude,,0.5\n"));
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].what, "B2 leaves B1");
  EXPECT_EQ(events[0].time, 45);
  EXPECT_FALSE(events[0].minus);
  EXPECT_EQ(events[0].quantity.component, Quantity::Component::magnitude);
  EXPECT_EQ(events[1].minus->of, "B2");
  EXPECT_EQ(events[1].reaches, 5);
  EXPECT_EQ(events[1].criterion, "B3.displacement.y − B2.displacement.y ≥ 5");
}

TEST_F(EventFile, FaultsNameTheLine) {
  const auto fault = [&](const std::string& row) -> std::string {
    try {
      read_reference_events(write("time,event,quantity,minus,reaches\n" + row + "\n"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(fault("soon,x,P1.displacement.y,,5"), testing::HasSubstr("line 2: 'soon' is no number"));
  EXPECT_THAT(fault("45,x,P1.up,,5"), testing::HasSubstr("line 2: 'P1.up' is no quantity"));
  EXPECT_THAT(fault("45,x,P1.displacement.y"), testing::HasSubstr("line 2: has 3 columns"));
  EXPECT_THAT(fault("45,x,P1.displacement.y,,5m"), testing::HasSubstr("'5m' is no number"));
}

}  // namespace
}  // namespace talus
