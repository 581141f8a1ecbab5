#include "widgets/view/compared_viewport.hpp"

#include "driven_window.hpp"
#include "session/compared_results.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

TEST_F(DrivenWindow, OtherResultsAreShownBesideAtTheSameMomentFromTheSamePlace) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return !session->playback.isLive() && !session->playback.folder().empty(); }));
  const auto other = folder / "other.results";
  std::filesystem::copy(session->playback.folder(), other, std::filesystem::copy_options::recursive);
  auto* beside = window->findChild<ComparedViewport*>();
  ASSERT_FALSE(beside->isVisible());

  window->compareWith(other);
  ASSERT_TRUE(wait([&] { return beside->isVisible() && beside->scene() && session->compared.frame(); }));
  session->playback.showFrame(3);
  ASSERT_TRUE(wait([&] { return session->compared.frame()->index == 3; }));
  const auto same = [&] {
    return (beside->scene()->pose().position - window->viewport().pose()->position).norm() < 1e-9;
  };
  ASSERT_TRUE(wait(same));

  const CameraPose before = *window->viewport().pose();
  QWidget& surface = *beside->surface().widget();
  drag(surface, {60, 60}, {120, 80});
  EXPECT_GT((window->viewport().pose()->position - before.position).norm(), 0.1) << "turned in the other one";
  EXPECT_TRUE(wait(same));
  window->viewport().look(View::top);
  EXPECT_TRUE(wait(same));

  session->compared.close();
  EXPECT_FALSE(beside->isVisible());
  window->compareWith(folder / "none.results");
  ASSERT_TRUE(wait([&] { return !session->messages.problems().empty(); }));
  EXPECT_FALSE(beside->isVisible());
}

}  // namespace
}  // namespace talus
