#include "study/accuracy/ladder.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "support/sample.hpp"

namespace talus {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<std::string> labels(const Ladder& ladder) {
  std::vector<std::string> labels;
  for (const Setting& setting : ladder.settings) labels.push_back(label_of(setting, ladder.settings.front()));
  return labels;
}

TEST(Ladder, IsAStarWithCheapOnesAndTheFinest) {
  const Ladder ladder = make_ladder(sample("incline_slide"), parse_ladder_wish({"body,time_step,mesh_size"}, {}));
  EXPECT_THAT(
      labels(ladder),
      testing::ElementsAre("tetrahedra · the project's own", "rigid", "affine", "tetrahedra · 4Δ", "tetrahedra · 2Δ",
                           "tetrahedra · Δ/2", "tetrahedra · Δ/4", "tetrahedra · 2h", "tetrahedra · h/2", "rigid · 4Δ",
                           "affine · 4Δ", "tetrahedra · 4Δ · 2h", "rigid · Δ/4", "affine · Δ/4",
                           "tetrahedra · 4Δ · h/2", "tetrahedra · Δ/4 · 2h", "tetrahedra · Δ/4 · h/2"));
  EXPECT_EQ(ladder.finest, 16);
  EXPECT_THAT(ladder.left_out, SizeIs(0));
}

TEST(Ladder, TakesTheValuesThatAreGiven) {
  const Ladder ladder = make_ladder(sample("incline_slide"), parse_ladder_wish({"time_step"}, {"time_step=1,0.5"}));
  EXPECT_THAT(labels(ladder), testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · Δ/2"));
  EXPECT_EQ(ladder.finest, 1);
}

TEST(Ladder, GoesAlongTheToleranceOfTheSolver) {
  const Ladder usual = make_ladder(sample("incline_slide"), parse_ladder_wish({"tolerance"}, {}));
  EXPECT_THAT(labels(usual), testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · tolerance draft",
                                                  "tetrahedra · tolerance reference"));
  EXPECT_EQ(usual.finest, 2) << "the project is solved to that of standard";
  Project draft = sample("incline_slide");
  draft.solver.tolerance = draft_tolerance.value;
  const Ladder finer = make_ladder(draft, parse_ladder_wish({}, {"tolerance=draft,1e-5"}));
  EXPECT_THAT(labels(finer), testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · tolerance 1e-5"));
  EXPECT_EQ(finer.finest, 1);
  EXPECT_EQ(under(finer.settings[1], draft).solver.tolerance, 1e-5);
  EXPECT_THROW(make_ladder(draft, parse_ladder_wish({}, {"tolerance=fine"})), InputError);
  EXPECT_THROW(make_ladder(draft, parse_ladder_wish({}, {"tolerance=0.1"})), InputError);
}

TEST(Ladder, GoesAlongContacts) {
  const Project project = sample("incline_slide");
  const Ladder ladder = make_ladder(project, parse_ladder_wish({"contact,contact_stiffness"}, {}));
  EXPECT_THAT(labels(ladder), testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · contact facet-wise",
                                                   "tetrahedra · stiffness ×0.5", "tetrahedra · stiffness ×2"));
  EXPECT_EQ(ladder.finest, 3) << "stiff springs give way least";
  EXPECT_EQ(under(ladder.settings[1], project).solver.contact, ContactModel::facet_wise);
  EXPECT_EQ(under(ladder.settings[3], project).solver.contact_stiffness, 2 * project.solver.contact_stiffness);
  EXPECT_EQ(size_on(StudyAxis::contact_stiffness, ladder.settings[3]), 0.5) << "half as soft";
  EXPECT_THROW(make_ladder(project, parse_ladder_wish({}, {"contact=point"})), InputError);
}

TEST(Ladder, LeavesOutTheStiffnessOfContactsWhereJointsHaveTheirOwn) {
  Project project = sample("incline_slide");
  for (Joint& joint : project.joints) joint.normal_stiffness = joint.shear_stiffness = 1e9;
  const Ladder ladder = make_ladder(project, parse_ladder_wish({"contact_stiffness"}, {}));
  EXPECT_THAT(ladder.settings, SizeIs(1));
  EXPECT_THAT(ladder.left_out, Contains(Field(&LeftOut::reason, "every joint has stiffnesses of its own")));
  const Ladder alone = make_ladder(sample("free_fall"), parse_ladder_wish({"contact,contact_stiffness"}, {}));
  EXPECT_THAT(alone.left_out, SizeIs(2));
}

TEST(Ladder, HasThePapersSchemeAsARun) {
  const Ladder usual = make_ladder(sample("incline_slide"), parse_ladder_wish({"scheme"}, {}));
  EXPECT_THAT(labels(usual), testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · scheme paper"));
  EXPECT_EQ(usual.finest, 0) << "no scheme is finer";
  EXPECT_THAT(labels(make_ladder(sample("incline_slide"), {})), Contains("tetrahedra · scheme paper"));
  Project paper = sample("incline_slide");
  paper.solver = settings_of(Preset::paper);
  EXPECT_THAT(labels(make_ladder(paper, parse_ladder_wish({"scheme"}, {}))),
              testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · scheme talus"));
  EXPECT_THROW(make_ladder(paper, parse_ladder_wish({}, {"scheme=shi"})), InputError);
}

TEST(Ladder, TakesTheAxesWhoseValuesAreGiven) {
  const Ladder alone = make_ladder(sample("incline_slide"), parse_ladder_wish({}, {"time_step=1,0.5"}));
  EXPECT_THAT(labels(alone), testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · Δ/2"));
  const Ladder both = make_ladder(sample("incline_slide"), parse_ladder_wish({"static_step"}, {"time_step=0.5"}));
  EXPECT_THAT(labels(both),
              testing::ElementsAre("tetrahedra · the project's own", "tetrahedra · Δ/2", "tetrahedra · static Δ/2"));
}

TEST(Ladder, LeavesOutWhatMakesNoSenseAndSaysWhy) {
  Project project = sample("free_fall");
  project.in_situ = {InSituStress{}};
  const Ladder ladder = make_ladder(project, {});
  EXPECT_THAT(ladder.left_out, Contains(Field(&LeftOut::reason, "rigid blocks bear no stress in situ")));
  EXPECT_THAT(ladder.left_out, Contains(Field(&LeftOut::reason, HasSubstr("nothing it could touch"))));
  EXPECT_THAT(ladder.left_out, Contains(Field(&LeftOut::reason, "no stage is static")));
  for (const Setting& setting : ladder.settings) EXPECT_NE(setting.body, BodyKind::rigid);
}

TEST(Ladder, LeavesTheMeshOfRigidBlocksAlone) {
  Project project = sample("incline_slide");
  project.solids[1].body = BodyKind::rigid;
  const Ladder ladder = make_ladder(project, parse_ladder_wish({"mesh_size,strain"}, {}));
  EXPECT_THAT(ladder.settings, SizeIs(1));
  EXPECT_THAT(ladder.left_out, SizeIs(2));
}

TEST(Ladder, RefusesWhatTheRulesOfProjectsRefuse) {
  Project project = sample("free_fall");
  project.monitors[0].stress = true;
  const Ladder ladder = make_ladder(project, parse_ladder_wish({"body"}, {}));
  EXPECT_THAT(ladder.left_out, Contains(Field(&LeftOut::reason, HasSubstr("has no stress"))));
}

TEST(Ladder, TellsWrongWishes) {
  EXPECT_THROW(parse_ladder_wish({"colour"}, {}), InputError);
  EXPECT_THROW(parse_ladder_wish({}, {"time_step"}), InputError);
  EXPECT_THROW(make_ladder(sample("wedge"), parse_ladder_wish({}, {"time_step=0"})), InputError);
  EXPECT_THROW(make_ladder(sample("wedge"), parse_ladder_wish({}, {"body=jelly"})), InputError);
}

}  // namespace
}  // namespace talus
