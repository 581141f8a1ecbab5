// A project is begun: new, from a template, as a copy of a sample, dropped.
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <fstream>

#include "answers.hpp"
#include "base/error.hpp"
#include "driven_window.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"
#include "templates/templates.hpp"
#include "widgets/begin/new_dialog.hpp"
#include "widgets/begin/project_preview.hpp"
#include "widgets/begin/recent_files.hpp"
#include "widgets/begin/samples.hpp"
#include "widgets/begin/start_page.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {
namespace {

class Begun : public DrivenWindow {
 protected:
  NewDialog* openDialog() {
    QTest::keyClick(window.get(), Qt::Key_N, Qt::ControlModifier);
    rest(30);
    auto* dialog = window->findChild<NewDialog*>();
    EXPECT_NE(dialog, nullptr) << "Ctrl+N";
    return dialog;
  }
  static QPushButton* button(const QWidget& parent, const char* words) {
    for (auto* one : parent.findChildren<QPushButton*>())
      if (one->text() == QString::fromUtf8(words) && one->isVisibleTo(&parent)) return one;
    ADD_FAILURE() << "no button " << words;
    return nullptr;
  }
  static NumberField* field(const QWidget& parent, const char* name) {
    for (auto* one : parent.findChildren<NumberField*>())
      if (one->isVisibleTo(&parent) && one->accessibleName() == QString::fromUtf8(name)) return one;
    ADD_FAILURE() << "no field " << name;
    return nullptr;
  }
  static void type(NumberField* field, const QString& text) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
  }
  /// Of all labels that are to be seen.
  static QString words(const QWidget& parent) {
    QStringList texts;
    for (const auto* label : parent.findChildren<QLabel*>())
      if (label->isVisibleTo(&parent)) texts << label->text();
    return texts.join(u'\n');
  }
  static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  StartCard* card(const QString& name) {
    for (auto* one : window->findChildren<StartCard*>())
      if (one->accessibleName() == name) return one;
    ADD_FAILURE() << "no card " << name.toStdString();
    return nullptr;
  }
  bool startPageIsShown() { return window->findChild<StartPage*>()->isVisible(); }
  bool stripIsShown() { return window->findChild<QWidget*>(QStringLiteral("problem-strip"))->isVisible(); }
  const Project& project() { return session->project.document().project(); }
  bool isMeshed() {
    return wait([&] { return !session->run.job().isBusy() && session->project.system(); });
  }
};

TEST_F(Begun, ATemplateBecomesAProjectWithTheNumbersThatAreTyped) {
  auto* dialog = openDialog();
  auto* list = dialog->findChild<QListWidget*>();
  list->setFocus();
  QTest::keyClicks(list, QStringLiteral("Col"));
  EXPECT_EQ(list->currentItem()->text(), QStringLiteral("Column"));
  type(field(*dialog, "Height"), QStringLiteral("6"));
  type(field(*dialog, "Friction angle"), QStringLiteral("22,5"));
  ASSERT_TRUE(wait([&] { return dialog->preview().isUpToDate(); }));
  click(button(*dialog, "Create"));
  ASSERT_TRUE(isMeshed());
  EXPECT_EQ(project(), project_from(template_named("column"), {{"height", 6}, {"friction", 22.5}}));
  EXPECT_EQ(session->project.system()->blocks.size(), 2U);
  EXPECT_FALSE(session->project.document().isSaved());
  EXPECT_TRUE(session->project.document().file().empty());
  EXPECT_FALSE(startPageIsShown());
  EXPECT_TRUE(session->run.whyNotSolve().isEmpty()) << session->run.whyNotSolve().toStdString();
}

TEST_F(Begun, AWrongNumberIsToldBesideItsFieldAndCreatesNothing) {
  auto* dialog = openDialog();
  dialog->choose("wedge");
  auto* plunge = field(*dialog, "Plunge ψ");
  type(plunge, QStringLiteral("70"));
  EXPECT_TRUE(words(*dialog).contains(QStringLiteral("Plunge ψ must be 20 to 50 °, is 70")))
      << words(*dialog).toStdString();
  EXPECT_EQ(plunge->property("state").toString(), QStringLiteral("error"));
  EXPECT_FALSE(button(*dialog, "Create")->isEnabled());
  type(plunge, QStringLiteral("steep"));
  EXPECT_TRUE(words(*dialog).contains(QStringLiteral("is not a number"))) << words(*dialog).toStdString();
  type(plunge, QStringLiteral("45 °"));
  EXPECT_FALSE(words(*dialog).contains(QStringLiteral("is not a number")));
  EXPECT_TRUE(button(*dialog, "Create")->isEnabled());
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_FALSE(session->project.document().isOpen());
}

TEST_F(Begun, AFieldShowsWhatWasTypedWhenTheKeyboardHasLeftIt) {
  auto* dialog = openDialog();
  dialog->choose("wedge");
  auto* plunge = field(*dialog, "Plunge ψ");
  type(plunge, QStringLiteral("45"));
  QTest::keyClick(plunge, Qt::Key_Tab);
  EXPECT_EQ(plunge->text(), QStringLiteral("45 °"));
  type(plunge, QStringLiteral("70"));
  QTest::keyClick(plunge, Qt::Key_Tab);
  EXPECT_EQ(plunge->text(), QStringLiteral("70"));
  EXPECT_EQ(plunge->property("state").toString(), QStringLiteral("error")) << "and that it is refused";
  EXPECT_FALSE(button(*dialog, "Create")->isEnabled());
  EXPECT_TRUE(words(*dialog).contains(QStringLiteral("is 70")));
  QTest::keyClick(plunge, Qt::Key_Escape);
  EXPECT_EQ(plunge->text(), QStringLiteral("45 °"));
  EXPECT_FALSE(words(*dialog).contains(QStringLiteral("is 70")));
  EXPECT_TRUE(button(*dialog, "Create")->isEnabled());
}

TEST_F(Begun, EveryFieldAndSentenceIsWholeToBeSeen) {
  auto* dialog = openDialog();
  for (const ProjectTemplate& candidate : project_templates()) {
    dialog->choose(candidate.key);
    rest(30);
    const int right = dialog->preview().mapTo(dialog, QPoint(0, 0)).x();
    for (auto* one : dialog->findChildren<NumberField*>()) {
      if (!one->isVisible()) continue;
      EXPECT_LE(one->mapTo(dialog, QPoint(one->width(), 0)).x(), right) << candidate.key;
      EXPECT_FALSE(one->visibleRegion().isEmpty()) << candidate.key;
    }
    for (auto* label : dialog->findChildren<QLabel*>()) {
      if (!label->isVisible() || !label->wordWrap()) continue;
      EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
    }
  }
}

TEST_F(Begun, ThePictureFollowsTheNumbers) {
  auto* dialog = openDialog();
  dialog->choose("dry-stone-wall");
  ASSERT_TRUE(wait([&] { return dialog->preview().isUpToDate() && !dialog->preview().picture().isNull(); }));
  const QImage before = dialog->preview().picture();
  EXPECT_EQ(before.size(), dialog->preview().size());
  type(field(*dialog, "Courses"), QStringLiteral("2"));
  EXPECT_FALSE(dialog->preview().isUpToDate());
  ASSERT_TRUE(wait([&] { return dialog->preview().isUpToDate(); }));
  EXPECT_NE(dialog->preview().picture(), before);
}

TEST_F(Begun, AnEmptyProjectIsOpenedSavedAndOpenedAgainAndSaysWhatItLacks) {
  auto* dialog = openDialog();
  dialog->choose(empty_key);
  click(button(*dialog, "Create"));
  rest(30);
  EXPECT_TRUE(session->project.document().isOpen());
  EXPECT_EQ(project(), emptyProject());
  EXPECT_EQ(session->run.whyNotSolve(), QStringLiteral("The project has no solid"));
  const auto& problems = session->project.problems().all();
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(),
                          [](const Problem& one) { return one.field == QStringLiteral("/solids"); }));
  EXPECT_FALSE(stripIsShown()) << "what is not there yet is no fault";
  EXPECT_TRUE(button(window->viewport(), "Import geometry…")->isEnabled()) << "there is no rock yet";
  const auto* refine = window->findChild<QToolButton*>(QStringLiteral("refine"));
  EXPECT_FALSE(refine->isEnabled()) << "no place can be clicked";
  EXPECT_EQ(refine->toolTip(), QStringLiteral("There is no rock yet"));
  ASSERT_TRUE(session->project.saveAs(folder / "empty.talus"));
  EXPECT_TRUE(session->project.document().isSaved());
  window->open(folder / "empty.talus");
  EXPECT_EQ(project(), emptyProject());
  EXPECT_THROW(read_project(folder / "empty.talus"), InputError) << "a run needs more";
}

TEST_F(Begun, ASampleIsOpenedAsACopyThatSavesElsewhere) {
  const auto shipped = samplesFolder() / "step_slope";
  const std::string before = read_whole_file(shipped / "step_slope.talus");
  click(card(samplesIn(samplesFolder()).size() ? QString::fromStdString(read_project(shipped / "step_slope.talus").name)
                                               : QString()));
  ASSERT_TRUE(session->project.document().isOpen());
  EXPECT_TRUE(session->project.document().file().empty());
  ASSERT_TRUE(isMeshed()) << "its STEP file is found where it lies";
  Project changed = project();
  changed.name = "Changed";
  session->project.document().change(changed, QStringLiteral("rename"));
  EXPECT_FALSE(session->project.document().isSaved());
  ASSERT_TRUE(session->project.saveAs(folder / "mine.talus"));
  EXPECT_EQ(read_whole_file(shipped / "step_slope.talus"), before);
  EXPECT_TRUE(std::filesystem::exists(folder / "slope.step")) << "what the project names comes along";
  EXPECT_EQ(read_project(folder / "mine.talus").name, "Changed");
}

TEST_F(Begun, APictureIsReadWhenItsCardComesIntoView) {
  const QString file = QString::fromStdString((folder / "preview.png").string());
  StartCard card(QStringLiteral("Sample"), QStringLiteral("It slides."), file);
  QPixmap picture(1200, 750);
  picture.fill(Qt::red);
  ASSERT_TRUE(picture.save(file)) << "written after the card was made";
  card.resize(216, 200);
  EXPECT_EQ(card.grab().toImage().pixelColor(100, 50), QColor(Qt::red));
}

TEST_F(Begun, PicturesOfCardsAreThoseOfTheTheme) {
  const QString file = QString::fromStdString((folder / "preview.png").string());
  const auto write = [](QString name, Qt::GlobalColor colour) {
    QPixmap picture(1200, 750);
    picture.fill(colour);
    ASSERT_TRUE(picture.save(name));
  };
  write(file, Qt::red);
  write(QString::fromStdString((folder / "preview-dark.png").string()), Qt::blue);
  StartCard card(QStringLiteral("Sample"), QStringLiteral("It slides."), file);
  card.resize(216, 200);
  const auto shown = [&card] { return card.grab().toImage().pixelColor(100, 50); };
  EXPECT_EQ(shown(), QColor(Qt::red));
  theme::install(true);
  EXPECT_EQ(shown(), QColor(Qt::blue));
  theme::install(false);
  EXPECT_EQ(shown(), QColor(Qt::red)) << "back again";
}

TEST_F(Begun, NoCardIsLightInTheDark) {
  for (const bool dark : {false, true}) {
    theme::install(dark);
    const QList<StartCard*> cards = window->findChildren<StartCard*>();
    EXPECT_GE(cards.size(), 18) << "templates, the empty one and samples";
    for (StartCard* one : cards) {
      const QImage image = one->grab().toImage().convertToFormat(QImage::Format_Grayscale8);
      double sum = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
      const double mean = sum / (image.width() * image.height());
      EXPECT_EQ(mean < 128, dark) << one->accessibleName().toStdString() << ", lightness " << mean << " of 255";
    }
  }
  theme::install(false);
}

TEST_F(Begun, TheStartPageLeadsBackToTheProject) {
  window->open(slidingCube());
  const auto show = [&] {
    for (auto* action : window->actions())
      if (action->text() == QStringLiteral("Start page")) action->trigger();
    rest(30);
    ASSERT_TRUE(startPageIsShown());
  };
  show();
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_FALSE(startPageIsShown());
  show();
  click(button(*window->findChild<StartPage*>(), "Return to the project"));
  EXPECT_FALSE(startPageIsShown());
  EXPECT_EQ(session->project.document().name(), QStringLiteral("Sliding cube"));
}

TEST_F(Begun, BeforeAProjectIsOpenThereIsNothingToReturnTo) {
  auto* page = window->findChild<StartPage*>();
  for (auto* one : page->findChildren<QPushButton*>())
    EXPECT_NE(one->isVisible() ? one->text() : QString(), QStringLiteral("Return to the project"));
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_TRUE(startPageIsShown());
}

TEST_F(Begun, CardsKeepTheirWordsBelowTheirPicturesAtEverySize) {
  for (const QSize& size : {QSize(1600, 1000), QSize(1280, 720), QSize(1900, 900)}) {
    window->resize(size);
    rest(50);
    for (const auto* one : window->findChildren<StartCard*>())
      EXPECT_GE(one->height(), one->heightForWidth(one->width())) << size.width();
    const QList<QWidget*> parts = card(QStringLiteral("Wedge"))->findChildren<QWidget*>();
    ASSERT_EQ(parts.size(), 3) << "picture, name, description";
    EXPECT_GE(parts[0]->height(), parts[0]->heightForWidth(parts[0]->width())) << size.width();
    EXPECT_GE(parts[1]->y(), parts[0]->geometry().bottom()) << size.width();
    EXPECT_GE(parts[2]->y(), parts[1]->geometry().bottom()) << size.width();
  }
}

TEST_F(Begun, RecentFilesHaveAPictureAndOneThatIsGoneIsForgotten) {
  const auto file = slidingCube();
  openAndMesh(file);
  window->open(sample("free_fall"));
  const QImage light = pictureOf(file, false).toImage(), dark = pictureOf(file, true).toImage();
  ASSERT_FALSE(light.isNull() || dark.isNull()) << "kept when the project was left";
  EXPECT_GT(light.pixelColor(2, 2).lightness(), 2 * dark.pixelColor(2, 2).lightness()) << "the sky of each theme";
  ASSERT_GE(recentFiles().size(), 2U);
  EXPECT_EQ(recentFiles()[1].path, file);
  std::filesystem::remove(file);
  for (auto* action : window->actions())
    if (action->text() == QStringLiteral("Start page")) action->trigger();
  rest(30);
  QToolButton* forget = nullptr;
  for (auto* one : window->findChild<StartPage*>()->findChildren<QToolButton*>())
    if (one->accessibleName() == QStringLiteral("Forget %1").arg(QString::fromStdString(file.string()))) forget = one;
  ASSERT_NE(forget, nullptr);
  click(forget);
  rest(30);
  for (const RecentFile& recent : recentFiles()) EXPECT_NE(recent.path, file);
  for (const bool isDark : {false, true}) EXPECT_TRUE(pictureOf(file, isDark).isNull());
}

TEST_F(Begun, AProjectOrAResultsFolderIsDropped) {
  drop(slidingCube(5));
  EXPECT_EQ(session->project.document().name(), QStringLiteral("Sliding cube"));
  session->solve();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy() && session->playback.frame(); }));
  drop(sample("free_fall"));
  EXPECT_NE(session->project.document().name(), QStringLiteral("Sliding cube"));
  drop(folder / "cube.results");
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  EXPECT_EQ(session->project.document().name(), QStringLiteral("Sliding cube"));
}

/// Not a test: draws the templates' pictures for the start page, light and dark, into the folder that TALUS_PICTURES
/// names.
TEST_F(Begun, DISABLED_DrawsTheTemplates) {
  for (const bool dark : {false, true}) {
    theme::install(dark);
    for (const ProjectTemplate& candidate : project_templates()) {
      ProjectPreview preview;
      preview.resize(560, 315);
      preview.show();
      preview.setProject(project_from(candidate));
      ASSERT_TRUE(wait([&] { return preview.isUpToDate() && !preview.picture().isNull(); }));
      ASSERT_TRUE(preview.picture().save(qEnvironmentVariable("TALUS_PICTURES") + u'/' +
                                         QString::fromStdString(candidate.key) +
                                         (dark ? QStringLiteral("-dark.png") : QStringLiteral(".png"))));
    }
  }
  theme::install(false);
}

}  // namespace
}  // namespace talus
