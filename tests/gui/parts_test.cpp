#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "widgets/begin/samples.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/plot.hpp"
#include "widgets/kit/tokens.hpp"
#include "widgets/project/page_table.hpp"
#include "widgets/view/camera_moves.hpp"

namespace talus {
namespace {

TEST(Numbers, TimesAreRoundedAsTheyAreRead) {
  EXPECT_EQ(numbers::duration(0.0214).toStdString(), "0.021 s");
  EXPECT_EQ(numbers::duration(3.14).toStdString(), "3.1 s");
  EXPECT_EQ(numbers::duration(42.4).toStdString(), "42 s");
  EXPECT_EQ(numbers::duration(59.8).toStdString(), "1 min");
  EXPECT_EQ(numbers::duration(251).toStdString(), "4 min 10 s");
  EXPECT_EQ(numbers::duration(6420).toStdString(), "1 h 47 min");
  EXPECT_EQ(numbers::duration(NAN).toStdString(), "–");
}

TEST(Numbers, OfTheCoresSentencesAreWrittenAsAllOthers) {
  const auto written = [](const char* said) { return numbers::inSentence(said).toStdString(); };
  EXPECT_EQ(written("falls at -1.73 m/s"), "falls at −1.73 m/s");
  EXPECT_EQ(written("(0, -2, -1e+06) m"), "(0, −2, −1\u2009000\u2009000) m");
  EXPECT_EQ(written("Cubes of masses 1 : 1e8, 5.5e-3 deep"), "Cubes of masses 1 : 1×10⁸, 0.0055 deep");
  EXPECT_EQ(written("3.25e-07."), "3.25×10⁻⁷.");
  for (const char* name : {"wall-3", "Dips 1-2", "e5", "x1e5", "2012, 28(6), 1602–1616", "v1.2.3", "pp. 12-15"})
    EXPECT_EQ(written(name), name);
}

TEST(Numbers, AreReadAsPeopleTypeThem) {
  double value = 0;
  EXPECT_TRUE(numbers::parse(QStringLiteral(" 12 500,5 "), value));
  EXPECT_EQ(value, 12500.5);
  EXPECT_TRUE(numbers::parse(QStringLiteral("−3e-2"), value));
  EXPECT_EQ(value, -0.03);
  value = 7;
  for (const char* word : {"", "nan", "inf", "12 m", "1.2.3"})
    EXPECT_FALSE(numbers::parse(QString::fromUtf8(word), value)) << word;
  EXPECT_EQ(value, 7);
}

TEST(Numbers, OrientationHasThreeDigitsOfDirection) {
  EXPECT_EQ(numbers::orientation(84, 12).toStdString(), "84/012");
  EXPECT_EQ(numbers::orientation(34.4, 359.7).toStdString(), "34/000");
}

CameraPose southView() {
  CameraPose pose;
  pose.position = {0, -100, 50};
  pose.focal_point = {0, 0, 0};
  pose.view_up = {0, 0, 1};
  return pose;
}

TEST(Camera, TurnsRoundTheFocalPointAndStopsAtThePole) {
  const CameraPose pose = southView();
  const CameraPose east = turned(pose, 90, 0);
  EXPECT_NEAR((east.position - Vec3(100, 0, 50)).norm(), 0, 1e-9);
  const CameraPose above = turned(pose, 0, 500);
  EXPECT_NEAR(above.position.norm(), pose.position.norm(), 1e-9);
  EXPECT_LT(std::hypot(above.position.x(), above.position.y()), 0.02 * above.position.norm());
  EXPECT_GT(std::hypot(above.position.x(), above.position.y()), 0);
}

/// Where a point is drawn, pixels from the upper left corner.
QPointF drawnAt(const CameraPose& pose, const Vec3& point, QSizeF view) {
  const Vec3 forward = (pose.focal_point - pose.position).normalized();
  const Vec3 right = forward.cross(pose.view_up).normalized(), up = right.cross(forward);
  const Vec3 from = point - pose.position;
  const double half = pose.parallel ? pose.parallel_scale : from.dot(forward) * std::tan(pose.view_angle * M_PI / 360);
  const double scale = view.height() / 2 / half;
  return {view.width() / 2 + from.dot(right) * scale, view.height() / 2 - from.dot(up) * scale};
}

TEST(Camera, ZoomKeepsWhatIsUnderThePointer) {
  const QSizeF view(800, 600);
  for (const bool parallel : {false, true}) {
    CameraPose pose = southView();
    pose.parallel = parallel;
    pose.parallel_scale = 30;
    const Vec3 right = (pose.focal_point - pose.position).cross(pose.view_up).normalized();
    const Vec3 point = pose.focal_point + 12 * right;
    const QPointF before = drawnAt(pose, point, view);
    const QPointF after = drawnAt(zoomed(pose, 0.5, before, view), point, view);
    EXPECT_NEAR(after.x(), before.x(), 1e-6);
    EXPECT_NEAR(after.y(), before.y(), 1e-6);
  }
}

TEST(Camera, PanMovesWhatIsAtTheFocalDepthWithTheHand) {
  const QSizeF view(800, 600);
  const CameraPose pose = southView();
  const QPointF after = drawnAt(panned(pose, {35, -20}, view), pose.focal_point, view);
  EXPECT_NEAR(after.x(), 435, 1e-6);
  EXPECT_NEAR(after.y(), 280, 1e-6);
}

TEST(Camera, TheOtherProjectionShowsTheFocalPlaneInTheSameSize) {
  const QSizeF view(800, 600);
  const CameraPose pose = southView();
  const Vec3 right = (pose.focal_point - pose.position).cross(pose.view_up).normalized();
  const CameraPose other = withOtherProjection(pose);
  EXPECT_TRUE(other.parallel);
  EXPECT_NEAR(drawnAt(other, 5 * right, view).x(), drawnAt(pose, 5 * right, view).x(), 1e-6);
  EXPECT_NEAR((withOtherProjection(other).position - pose.position).norm(), 0, 1e-9);
}

TEST(Plot, ReadsACurveBetweenItsPoints) {
  const Curve curve{{}, 0, {0, 1, 3}, {0, 10, 30}};
  EXPECT_DOUBLE_EQ(*valueAt(curve, 2), 20);
  EXPECT_DOUBLE_EQ(*valueAt(curve, 0), 0);
  EXPECT_DOUBLE_EQ(*valueAt(curve, 3), 30);
  EXPECT_FALSE(valueAt(curve, 3.1));
}

/// The highest pixel of the first curve's colour between the axis and the curve's name; the picture's height without
/// one.
int highestOfTheCurve(const QImage& picture) {
  const QColor ink = seriesColours(false)[0];
  for (int row = 0; row < picture.height(); ++row)
    for (int column = 60; column < 240; ++column) {
      const QColor at = picture.pixelColor(column, row);
      if (std::abs(at.red() - ink.red()) + std::abs(at.green() - ink.green()) + std::abs(at.blue() - ink.blue()) < 120)
        return row;
    }
  return picture.height();
}

TEST(Plot, DrawsNothingWithoutPoints) {
  Plot plot(QStringLiteral("Speed"));
  plot.resize(300, 160);
  plot.setCurves({{QStringLiteral("P1"), 0, {}, {}}}, QStringLiteral("m/s"));
  const QImage picture = plot.grab().toImage();
  EXPECT_EQ(highestOfTheCurve(picture), picture.height());
}

/// Beside its first number: there is no room for a line of its own below the axis.
TEST(Plot, SaysThatTheAxisBelowIsTime) {
  Plot plot(QStringLiteral("Speed"));
  plot.resize(300, 160);
  plot.setCurves({{QStringLiteral("P1"), 0, {0, 1}, {0, 1}}}, QStringLiteral("m/s"));
  const QImage picture = plot.grab().toImage();
  const QColor paper = picture.pixelColor(2, 158);
  int ink = 0;
  for (int row = 138; row < 156; ++row)
    for (int column = 0; column < 36; ++column) ink += picture.pixelColor(column, row) != paper;
  EXPECT_GT(ink, 30);
}

TEST(Plot, CutsNoDigitOffTheNumbersOfItsAxis) {
  Plot plot(QStringLiteral("Energy"));
  plot.resize(240, 160);
  plot.setCurves({{QStringLiteral("kinetic"), 0, {0, 1}, {0, 0.0012345}}}, QStringLiteral("J"));
  const QImage picture = plot.grab().toImage();
  const QColor paper = picture.pixelColor(0, 1);
  const auto inked = [&](int column) {
    int ink = 0;
    for (int row = 26; row < 134; ++row) ink += picture.pixelColor(column, row) != paper;
    return ink > 0;
  };
  int first = 0;
  while (first < picture.width() && !inked(first)) ++first;
  EXPECT_GE(first, 2) << "the first digit begins within the picture";
  EXPECT_LT(first, 40) << "there are numbers";
}

TEST(Plot, EnergiesAndLengthsHaveThePrefixThatSuitsThem) {
  EXPECT_EQ(numbers::energyScale(8e-4).unit, QStringLiteral("µJ"));
  EXPECT_EQ(numbers::energyScale(0.25).unit, QStringLiteral("mJ"));
  EXPECT_EQ(numbers::energyScale(25).unit, QStringLiteral("J"));
  EXPECT_EQ(numbers::energyScale(2.5e7).unit, QStringLiteral("MJ"));
  EXPECT_EQ(numbers::energyScale(0).unit, QStringLiteral("J"));
  const numbers::Scale small = numbers::scaleOf(8e-4, "m");
  EXPECT_EQ(small.unit, QStringLiteral("mm"));
  EXPECT_NEAR(8e-4 / small.factor, 0.8, 1e-12);
  EXPECT_EQ(numbers::scaleOf(2, "m/s").unit, QStringLiteral("m/s"));
}

TEST(Plot, KeepsOneSpikeAmongManyPoints) {
  Plot plot(QStringLiteral("Speed"));
  plot.resize(300, 160);
  std::vector<double> x, y(20000, 1);
  for (std::size_t i = 0; i < y.size(); ++i) x.push_back(0.01 * static_cast<double>(i));
  plot.setCurves({{QStringLiteral("P1"), 0, x, y}}, QStringLiteral("m/s"));
  const int flat = highestOfTheCurve(plot.grab().toImage());
  y[12345] = 5;
  plot.setCurves({{QStringLiteral("P1"), 0, x, y}}, QStringLiteral("m/s"));
  const int spike = highestOfTheCurve(plot.grab().toImage());
  EXPECT_LT(flat, 160) << "the curve is drawn";
  EXPECT_LT(spike, 60) << "up to the plot's top";
}

TEST(Samples, AreFoundWithTheirNames) {
  const auto samples = samplesIn(std::filesystem::path(TALUS_SOURCE_DIR) / "samples");
  std::size_t folders = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TALUS_SOURCE_DIR) / "samples"))
    folders += entry.is_directory() ? 1 : 0;
  ASSERT_GE(folders, 5u);
  EXPECT_EQ(samples.size(), folders);
  for (const Sample& sample : samples) {
    EXPECT_FALSE(sample.name.isEmpty()) << sample.project;
    EXPECT_TRUE(sample.description.endsWith(u'.')) << sample.project << ": " << sample.description.toStdString();
  }
  const auto fall = std::find_if(samples.begin(), samples.end(),
                                 [](const Sample& sample) { return sample.project.stem() == "free_fall"; });
  ASSERT_NE(fall, samples.end());
  EXPECT_EQ(fall->name.toStdString(), "Free fall");
  EXPECT_TRUE(samplesIn("/nowhere").empty());
}

TEST(PageTable, ListsEveryCutUnderItsJointAndJointsWithoutOne) {
  Project project;
  project.joints.resize(2);
  project.joints[0].name = "J1";
  project.joints[0].friction_angle = 30;
  project.joints[0].cohesion = 2e6;
  project.joints[1].name = "J2";
  Cut cut;
  cut.joint = "J1";
  cut.dip = 34;
  cut.dip_direction = 70;
  cut.spacing = 2.5;
  cut.count = 3;
  project.cuts = {cut};
  const PageRows rows = rowsOf(WorkflowPage::joints, project);
  ASSERT_EQ(rows.rows.size(), 2u);
  EXPECT_EQ(rows.rows[0].item, (Item{Item::Kind::cut, 0}));
  EXPECT_EQ(rows.rows[0].cells.join(u'|').toStdString(), "J1|1|infinite|–|34.0|070|0, 0, 0|2.50|3|30.0|2.00");
  EXPECT_EQ(rows.rows[1].item, (Item{Item::Kind::joint, 1}));
  for (const auto& row : rows.rows) EXPECT_EQ(row.cells.size(), rows.heads.size());
}

TEST(PageTable, SaysHowLongATableIsAndThatAWholeBlockMoves) {
  Project project;
  project.loads = {{"top", {1, 2, 3}, {0, 0, -2e6}}, {"top", {1, 2, 3}, {0, 0, 0}, {{0, {0, 0, 0}}, {2.5, {1, 0, 0}}}}};
  project.constraints = {{"base", {}, {0, 0, 0}, {{1, {0, 0, 0}}}}, {"top", Vec3(0, 0, 1), {0, {}, 0.5}}};
  const PageRows rows = rowsOf(WorkflowPage::loads, project);
  ASSERT_EQ(rows.rows.size(), 4u);
  EXPECT_EQ(rows.rows[0].cells.join(u'|').toStdString(), "force, kN|top|1.000, 2.000, 3.000|0, 0, −2000");
  EXPECT_EQ(rows.rows[1].cells.last().toStdString(), "2 rows, 0 … 2.500 s");
  EXPECT_EQ(rows.rows[2].cells.join(u'|').toStdString(), "support, m|base|whole block|1 row, 1.000 … 1.000 s");
  EXPECT_EQ(rows.rows[3].cells.last().toStdString(), "0, free, 0.500");
}

TEST(PageTable, SaysThatAStageEndsAtEquilibrium) {
  Project project;
  project.stages.resize(2);
  project.stages[0].kind = StageKind::static_;
  project.stages[0].time_step = project.stages[1].time_step = 0.01;
  project.stages[0].steps = project.stages[1].steps = 10;
  project.stages[0].until_equilibrium = true;
  const PageRows rows = rowsOf(WorkflowPage::stages, project);
  ASSERT_EQ(rows.rows.size(), 2u);
  EXPECT_EQ(rows.rows[0].cells[1].toStdString(), "static, until equilibrium");
  EXPECT_EQ(rows.rows[1].cells[1].toStdString(), "dynamic");
}

}  // namespace
}  // namespace talus
