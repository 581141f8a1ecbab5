#include "widgets/results/event_list.hpp"

#include <QTabWidget>

#include "driven_window.hpp"

namespace talus {
namespace {

TEST_F(DrivenWindow, EventsAreListedAndLeadToTheirMoment) {
  openAndMesh(slidingCube(100));
  auto& list = *window->findChild<EventList*>();
  EXPECT_TRUE(list.isHidden());
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return !session->playback.isLive() && !session->run.events().empty(); }));
  for (auto* tabs : window->findChildren<QTabWidget*>())
    if (tabs->isAncestorOf(&list)) tabs->setCurrentIndex(0);
  rest(100);
  ASSERT_TRUE(list.isVisible());
  const auto& events = session->run.events();
  ASSERT_EQ(list.rowCount(), static_cast<int>(events.size()));
  EXPECT_EQ(list.item(0, 1)->text(), QString::fromStdString(events[0].what));

  session->playback.showFrame(10);
  ASSERT_TRUE(wait([&] { return session->playback.number() == 10; }));
  EXPECT_TRUE(wait([&] { return list.currentRow() == list.rowCount() - 1; })) << "all have happened";
  session->playback.showFrame(0);
  ASSERT_TRUE(wait([&] { return session->playback.number() == 0; }));
  const int first = nearestFrame(session->playback.times(), events[0].time);
  ASSERT_GT(first, 0);
  EXPECT_TRUE(wait([&] { return list.currentRow() == -1; })) << "none has";
  QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(0, 1)).center());
  EXPECT_TRUE(wait([&] { return session->playback.number() == first; }));
  EXPECT_EQ(list.currentRow(), 0);

  session->display.goTo(WorkflowPage::blocks);
  EXPECT_TRUE(list.isHidden()) << "on a page that tells of no run";
}

}  // namespace
}  // namespace talus
