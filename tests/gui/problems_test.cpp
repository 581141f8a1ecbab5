// What is wrong with a project is listed all the time, as a compiler does, and each problem leads to where it is
// mended.
#include "widgets/project/problem_list.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <fstream>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/project/problem_count.hpp"

namespace talus {
namespace {

class Problems : public DrivenWindow {
 protected:
  std::vector<ProblemRow*> rows() {
    rest(150);
    std::vector<ProblemRow*> found;
    for (auto* row : window->findChild<ProblemList*>()->findChildren<ProblemRow*>()) found.push_back(row);
    return found;
  }
  QString count() { return window->findChild<ProblemCount*>()->text(); }
};

TEST_F(Problems, WhatIsOddIsListedAndEnterLeadsToItsField) {
  window->open(slidingCube(40));
  EXPECT_EQ(count(), QStringLiteral("No problems"));
  Project soft = session->project.document().project();
  soft.materials[0].young = 25;  // GPa were meant
  session->project.document().change(soft, QStringLiteral("change E"));
  const auto listed = rows();
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(count(), QStringLiteral("1 warning"));
  EXPECT_TRUE(listed[0]->accessibleName().startsWith(QStringLiteral("material rock, Young E: ")));
  EXPECT_TRUE(session->run.whyNotSolve().isEmpty()) << "it is odd, and can be solved";
  QTest::mouseClick(window->findChild<ProblemCount*>(), Qt::LeftButton);
  ASSERT_TRUE(listed[0]->isVisible());
  keepPicture(*window, "problems.png");
  listed[0]->setFocus();
  QTest::keyClick(listed[0], Qt::Key_Return);
  rest(50);
  EXPECT_EQ(session->display.page(), WorkflowPage::materials);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::material, 0}));
  auto* field = qobject_cast<NumberField*>(QApplication::focusWidget());
  ASSERT_NE(field, nullptr);
  EXPECT_EQ(field->objectName(), QStringLiteral("/materials/rock/young"));
  QTest::keyClicks(field, QStringLiteral("25 GPa"));
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_TRUE(rows().empty()) << "25 GPa";
  EXPECT_EQ(count(), QStringLiteral("No problems"));
}

TEST_F(Problems, OfWhatIsNotThereYetLeadToThePlusThatMakesIt) {
  window->open(write("bare.talus", R"({"talus": 1, "materials": {}, "solids": [], "stages": []})"));
  for (const auto& [list, page] : {std::pair("stages", "new/stages"), {"solids", "new/geometry"}}) {
    for (auto* row : rows())
      if (row->accessibleName().startsWith(QLatin1String(list))) click(button(*row, "Go there"));
    rest(50);
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    EXPECT_EQ(QApplication::focusWidget()->objectName().toStdString(), page);
  }
}

TEST_F(Problems, AreSaidInTheWordsOfTheForms) {
  window->open(write("bare.talus", R"({"talus": 1, "materials": {}, "solids": [], "stages": []})"));
  QStringList said;
  for (const auto* row : rows()) said << row->accessibleName() + u'|' + row->accessibleDescription();
  const std::string all = said.join(u'\n').toStdString();
  EXPECT_THAT(all, testing::HasSubstr("add one with a type, a time step, and steps or a duration"));
  EXPECT_EQ(all.find('_'), std::string::npos) << all;

  window->open(write("short.talus", R"({"talus": 1,
    "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
    "solids": [{"name": "cube", "box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "material": "rock"}],
    "stages": [{"name": "fall", "type": "dynamic", "time_step": 0.01, "duration": 1}]})"));
  session->project.selection().select({Item::Kind::stage, 0});
  rest(30);
  auto* field = window->findChild<NumberField*>(QStringLiteral("/stages/0/duration"));
  ASSERT_NE(field, nullptr);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("1 ms"));
  QTest::keyClick(field, Qt::Key_Return);
  rest(30);
  auto* problem = window->findChild<QLabel*>(QStringLiteral("/stages/0/duration#problem"));
  ASSERT_NE(problem, nullptr);
  EXPECT_THAT(problem->text().toStdString(), testing::HasSubstr("lengthen the duration or shorten the time step"));
}

TEST_F(Problems, ABrokenFileIsToldOfWhenTheProjectIsOpenedAndNothingCanBeSolvedUntilItIsMended) {
  const auto file = write("hill.talus", R"({"talus": 1, "name": "hill",
    "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
    "solids": [{"name": "hill", "file": "hill.step", "material": "rock", "body": "fixed"}],
    "monitors": [{"name": "P1", "block": "hill", "at": [0, 0, 0]}],
    "stages": [{"name": "s", "type": "dynamic", "time_step": 0.01, "steps": 2}]})");
  write("hill.step", "this is no STEP file");
  window->open(file);
  EXPECT_TRUE(session->run.whyNotSolve().isEmpty()) << "not known yet";
  ASSERT_TRUE(wait([&] { return !session->run.whyNotSolve().isEmpty(); }, 10000));
  ASSERT_EQ(rows().size(), 1u);
  EXPECT_EQ(count(), QStringLiteral("1 error"));
  EXPECT_TRUE(session->run.whyNotSolve().contains(QStringLiteral("hill.step")))
      << session->run.whyNotSolve().toStdString();
  EXPECT_EQ(session->project.system(), nullptr) << "nothing was cut to find out";
  rest(300);
  keepPicture(*window, "broken_file.png");
  click(button(*window->findChild<ProblemList*>(), "Go there"));
  rest(50);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::solid, 0}));
}

}  // namespace
}  // namespace talus
