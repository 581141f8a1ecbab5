#include "contact/history/resting_contacts.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

ContactHistory history(int a, int b, std::uint64_t key, double gap, bool bonded = false) {
  ContactHistory m{};
  m.key = key;
  m.bodies = {a, b};
  m.gap = gap;
  m.bonded = bonded;
  return m;
}

std::vector<std::uint64_t> keys_taken(RestingContacts& resting, int body, const std::function<bool(int)>& wakes) {
  std::vector<ContactHistory> histories;
  resting.take(body, wakes, histories);
  std::vector<std::uint64_t> keys;
  for (const ContactHistory& m : histories) keys.push_back(m.key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

TEST(RestingContacts, GiveBackThePairsThatWakeAndKeepTheOthers) {
  RestingContacts resting(4);
  resting.put(history(0, 1, 5, -0.1, true));
  resting.put(history(0, 1, 6, -0.2));
  resting.put(history(1, 2, 7, -0.5));
  resting.put(history(2, 3, 8, 0.1, true));
  EXPECT_EQ(resting.deepest(0), 0.2);
  EXPECT_EQ(resting.deepest(1), 0.5);
  EXPECT_EQ(resting.deepest(3), 0);

  EXPECT_EQ(keys_taken(resting, 2, [](int partner) { return partner == 1; }), (std::vector<std::uint64_t>{7}));
  EXPECT_EQ(resting.deepest(1), 0.2);
  EXPECT_EQ(resting.deepest(2), 0);
  EXPECT_EQ(keys_taken(resting, 1, [](int) { return true; }), (std::vector<std::uint64_t>{5, 6}));
  EXPECT_EQ(resting.deepest(0), 0);
  EXPECT_TRUE(resting.any_bonded());
  EXPECT_EQ(keys_taken(resting, 2, [](int) { return true; }), (std::vector<std::uint64_t>{8}));
  EXPECT_FALSE(resting.any_bonded());
  EXPECT_TRUE(keys_taken(resting, 2, [](int) { return true; }).empty());
}

TEST(RestingContacts, AreListedByBodies) {
  RestingContacts resting(3);
  resting.put(history(1, 2, 1, 0));
  resting.put(history(0, 2, 2, 0));
  resting.put(history(0, 1, 3, 0));
  std::vector<RestingContact> rows;
  resting.list([](int a, int) { return a == 0; }, rows);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].bodies[1], 1);
  EXPECT_EQ(rows[1].bodies[1], 2);
}

}  // namespace
}  // namespace talus
