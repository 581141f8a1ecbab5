#include "widgets/run/step_facts.hpp"

#include <QLabel>
#include <QRegularExpression>

#include "driven_window.hpp"
#include "listed_runs.hpp"

namespace talus {
namespace {

QString fact(const MainWindow& window, const char* name) {
  for (const auto* label : window.findChild<StepFacts*>()->findChildren<QLabel*>())
    if (label->accessibleName() == QLatin1String(name)) return label->text();
  return {};
}

TEST_F(DrivenWindow, SaysOfTheLastStepWhatItCostAndHowGoodItIs) {
  openAndMesh(slidingCube());
  for (const char* name : {"Pace", "Penetration", "Unbalanced", "Time error", "Remainder", "Numerical damping"})
    EXPECT_EQ(fact(*window, name), QString::fromUtf8("–")) << name;
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() > 50; }));
  session->run.job().pause();
  rest(300);
  keepPicture(*window, "step_facts.png");
  const QRegularExpression percent(QStringLiteral("^[0-9].* % of (mesh size|energy)$"));
  for (const char* name : {"Penetration", "Time error", "Remainder", "Numerical damping"})
    EXPECT_TRUE(percent.match(fact(*window, name)).hasMatch()) << name << ": " << fact(*window, name).toStdString();
  EXPECT_TRUE(fact(*window, "Pace").endsWith(QStringLiteral(" ms a step")));
  EXPECT_TRUE(fact(*window, "Unbalanced").endsWith(QStringLiteral(" kN")));
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
}

}  // namespace
}  // namespace talus
