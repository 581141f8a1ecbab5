// The window in German: its pages have German titles, and nothing on them is left in English.
#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableWidget>
#include <QTreeWidget>
#include <set>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "render/fields/field_classes.hpp"
#include "render/paint/picture_words.hpp"
#include "widgets/kit/language.hpp"
#include "widgets/view/timeline.hpp"
#include "widgets/window/rail.hpp"

namespace talus {
namespace {

using Texts = std::set<std::string>;

void collect(const QMenu& menu, Texts& texts) {
  texts.insert(menu.title().toStdString());
  for (const QAction* action : menu.actions()) {
    texts.insert(action->text().toStdString());
    if (action->menu()) collect(*action->menu(), texts);
  }
}

/// Why an effect is on, and what it is paid for: the core says so, in English.
bool isOfTheCore(const QLabel& label) {
  const QString role = label.property("role").toString();
  if (role != QLatin1String("small") && role != QLatin1String("faint")) return false;
  for (const QWidget* around = &label; around; around = around->parentWidget())
    if (around->inherits("talus::EffectList")) return true;
  return false;
}

class German : public DrivenWindow {
 protected:
  void TearDown() override {
    DrivenWindow::TearDown();
    language::install(QStringLiteral("en"));
  }

  void begin(const char* code) {
    language::install(QLatin1String(code));
    openWindow();
    openAndMesh(slidingCube(40));
  }

  /// All that can be read on a page, with what is selected.
  Texts textsOf(WorkflowPage page, const Item& item) {
    session->display.goTo(page);
    session->project.selection().select(item);
    rest(20);
    Texts texts;
    for (const auto* label : window->findChildren<QLabel*>())
      if (label->isVisible() && !isOfTheCore(*label)) texts.insert(label->text().toStdString());
    for (const auto* button : window->findChildren<QAbstractButton*>())
      if (button->isVisible()) texts.insert({button->text().toStdString(), button->toolTip().toStdString()});
    for (const auto* tabs : window->findChildren<QTabBar*>())
      for (int i = 0; i < tabs->count(); ++i) texts.insert(tabs->tabText(i).toStdString());
    for (const auto* table : window->findChildren<QTableWidget*>())
      for (int i = 0; table->isVisible() && i < table->columnCount(); ++i)
        if (table->horizontalHeaderItem(i)) texts.insert(table->horizontalHeaderItem(i)->text().toStdString());
    const auto* tree = window->findChild<QTreeWidget*>();
    for (int i = 0; i < tree->topLevelItemCount(); ++i) texts.insert(tree->topLevelItem(i)->text(0).toStdString());
    for (const QAction* title : window->findChild<QMenuBar*>()->actions()) collect(*title->menu(), texts);
    return texts;
  }

  Texts allTexts() {
    const std::vector<std::pair<WorkflowPage, Item>> places{{WorkflowPage::geometry, {Item::Kind::solid, 0}},
                                                            {WorkflowPage::joints, {Item::Kind::joint, 0}},
                                                            {WorkflowPage::blocks, {Item::Kind::block, 1}},
                                                            {WorkflowPage::mesh, {Item::Kind::mesh, 0}},
                                                            {WorkflowPage::materials, {Item::Kind::material, 0}},
                                                            {WorkflowPage::loads, {Item::Kind::monitor, 0}},
                                                            {WorkflowPage::stages, {Item::Kind::stage, 0}},
                                                            {WorkflowPage::stages, {Item::Kind::solver, 0}},
                                                            {WorkflowPage::solve, {}},
                                                            {WorkflowPage::results, {}},
                                                            {WorkflowPage::geometry, {}}};
    Texts all;
    for (const auto& [page, item] : places) all.merge(textsOf(page, item));
    return all;
  }
};

/// Words of four letters that are neither names of the project's things nor alike in both languages.
bool hasWords(const std::string& text) {
  static const QRegularExpression alike(QStringLiteral(
      "\\b(Sliding cube|base|cube|rock|slide|cube\\.talus|talus|Talus|Name|Block|Film|Text|Deutsch|English|Newmark|"
      "Fisher|Esc|Iterationen|Open–close|STEP|Position)\\b"));
  static const QRegularExpression word(QStringLiteral("\\p{L}{4,}"));
  return QString::fromStdString(text).remove(alike).contains(word);
}

TEST_F(German, PagesHaveGermanTitlesAndNothingIsLeftInEnglish) {
  begin("en");
  const Texts english = allTexts();
  begin("de");
  EXPECT_EQ(language::now(), QStringLiteral("de"));
  QStringList titles;
  for (const auto* item : window->findChildren<RailItem*>()) titles << item->accessibleName();
  for (const char* title :
       {"Geometrie", "Klüfte", "Blöcke", "Netz", "Werkstoffe", "Lasten", "Abschnitte", "Rechnen", "Ergebnisse"})
    EXPECT_TRUE(titles.contains(QString::fromUtf8(title))) << title;
  Texts left;
  for (const std::string& text : allTexts())
    if (english.contains(text) && hasWords(text)) left.insert(text);
  EXPECT_THAT(left, testing::IsEmpty());
}

TEST_F(German, TitlesOfFormsAreNotCutOff) {
  begin("de");
  for (const Item::Kind kind : {Item::Kind::material, Item::Kind::joint, Item::Kind::solid, Item::Kind::stage,
                                Item::Kind::solver, Item::Kind::monitor, Item::Kind::mesh}) {
    session->project.selection().select({kind, 0});
    rest(20);
    for (const auto* label : window->findChildren<QLabel*>()) {
      if (!label->isVisible() || label->property("role").toString() != QLatin1String("muted")) continue;
      const QRect needed = label->fontMetrics().boundingRect(QRect(0, 0, label->width(), 1000),
                                                             Qt::TextWordWrap | Qt::AlignLeft, label->text());
      EXPECT_LE(needed.width(), label->width() + 1) << label->text().toStdString();
      EXPECT_LE(needed.height(), label->height() + 2) << label->text().toStdString();
    }
  }
  keepPicture(*window, "german.png");
}

TEST_F(German, PicturesSpeakTheLanguageOfTheWindow) {
  EXPECT_EQ(picture_word("Displacement"), "Displacement");
  begin("de");
  for (const Field& field : all_fields()) {
    const std::string title(field.title);
    EXPECT_NE(picture_word(title), title);
  }
  EXPECT_EQ(picture_word("Displacement"), "Verschiebung");
  EXPECT_EQ(classes_of(field_named("asleep"))[2].word, "schläft");
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  rest(500);
  keepPicture(*window, "german_results.png");
  const auto* speed = window->timeline().findChild<QComboBox*>();
  QStyleOptionComboBox option;
  option.initFrom(speed);
  const QRect room = speed->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, speed);
  for (int i = 0; i < speed->count(); ++i)
    EXPECT_GE(room.width(), speed->fontMetrics().horizontalAdvance(speed->itemText(i)))
        << speed->itemText(i).toStdString();
}

TEST_F(German, CountsHaveTheirPlural) {
  begin("de");
  session->display.goTo(WorkflowPage::geometry);
  rest(20);
  Texts texts;
  for (const auto* label : window->findChildren<QLabel*>()) texts.insert(label->text().toStdString());
  EXPECT_THAT(texts, testing::Contains(testing::StartsWith("2 Körper")));
}

TEST_F(German, AnUnknownLanguageIsEnglish) {
  EXPECT_FALSE(language::install(QStringLiteral("xx")));
  EXPECT_EQ(language::now(), QStringLiteral("en"));
}

}  // namespace
}  // namespace talus
