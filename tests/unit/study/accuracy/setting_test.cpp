#include "study/accuracy/setting.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "study/accuracy/setting_json.hpp"
#include "support/sample.hpp"

namespace talus {
namespace {

TEST(Setting, TheProjectsOwnGivesItBack) {
  for (const char* name : {"free_fall", "incline_slide", "wedge", "block_ladder", "jiweishan"}) {
    const Project project = sample(name);
    EXPECT_EQ(under(own_setting(project), project), project) << name;
  }
}

TEST(Setting, OfUnlikeBlocksHasNoBody) {
  EXPECT_EQ(own_setting(sample("incline_slide")).body, BodyKind::tetrahedra);
  EXPECT_EQ(own_setting(sample("block_ladder")).body, std::nullopt);
}

TEST(Setting, ChangesEveryBlockThatMayMoveAndItsStages) {
  Project project = sample("incline_slide");
  project.stages[0].blocks = {{"block", BodyKind::fixed}};
  project.stages[1].blocks = {{"block", BodyKind::tetrahedra}};
  Setting setting = own_setting(project);
  setting.body = BodyKind::rigid;
  const Project rigid = under(setting, project);
  EXPECT_EQ(rigid.solids[0].body, BodyKind::fixed);
  EXPECT_EQ(rigid.solids[1].body, BodyKind::rigid);
  EXPECT_EQ(rigid.stages[0].blocks[0].body, BodyKind::fixed);
  EXPECT_EQ(rigid.stages[1].blocks[0].body, BodyKind::rigid);
}

TEST(Setting, KeepsTheModelTimeOfStages) {
  Project project = sample("incline_slide");
  Setting setting = own_setting(project);
  setting.time_step = 0.5;
  EXPECT_EQ(under(setting, project).stages[0], project.stages[0]);  // static: as it is
  setting.static_step = 0.5;
  EXPECT_EQ(under(setting, project).stages[0].steps, 40);
  EXPECT_DOUBLE_EQ(under(setting, project).stages[0].time_step, 0.0005);
  EXPECT_EQ(under(setting, project).stages[1].duration, 1);
  EXPECT_DOUBLE_EQ(under(setting, project).stages[1].time_step, 0.005);
  project.stages[1].duration.reset();
  project.stages[1].steps = 20;
  EXPECT_EQ(under(setting, project).stages[1].steps, 40);
  setting.time_step = 3;  // 20 steps are no multiple of 3
  EXPECT_FALSE(under(setting, project).stages[1].steps);
  EXPECT_DOUBLE_EQ(*under(setting, project).stages[1].duration, 0.2);
}

TEST(Setting, MakesFinerWhatTheProjectLeavesToTheMesher) {
  Project project = sample("free_fall");
  project.solids[0].mesh_size.reset();
  Setting setting = own_setting(project);
  setting.mesh_size = 0.5;
  EXPECT_DOUBLE_EQ(*under(setting, project).solids[0].mesh_size, 0.05);  // a tenth of 1 m, halved
  project.solids[0].shape = FileShape{"hill.step"};
  EXPECT_THROW(under(setting, project), InputError);
}

TEST(Setting, IsCalledByWhatIsNotTheProjectsOwn) {
  Setting own;
  own.body = BodyKind::tetrahedra;
  EXPECT_EQ(label_of(own, own), "tetrahedra · the project's own");
  Setting other = own;
  other.time_step = 0.5;
  other.static_step = 0.5;
  other.mesh_size = 2;
  other.penetration_tolerance = 1e-3;
  other.tolerance = 1e-3;
  EXPECT_EQ(label_of(other, own), "tetrahedra · Δ/2 · static Δ/2 · 2h · penetration 0.001 · tolerance draft");
}

TEST(Setting, ByAnotherSchemeIsAllOfThatScheme) {
  Project project = sample("incline_slide");
  project.solver.tolerance = draft_tolerance.value;
  const Setting own = own_setting(project), paper = by_scheme(Preset::paper, own);
  EXPECT_EQ(label_of(paper, own), "tetrahedra · scheme paper");
  SolverSettings expected = settings_of(Preset::paper);
  expected.tolerance = draft_tolerance.value;
  EXPECT_EQ(under(paper, project).solver, expected);
  Setting other = paper;
  other.strain = Strain::corotational;
  EXPECT_EQ(label_of(other, own), "tetrahedra · scheme paper · corotational");
  EXPECT_EQ(under(other, project).solver.strain, Strain::corotational);
}

TEST(Setting, OfAProjectWithAPresetKeepsWhatItSaysBesides) {
  Project project = sample("incline_slide");
  project.solver = settings_of(Preset::paper);
  project.solver.contact = ContactModel::area;
  const Setting own = own_setting(project);
  EXPECT_EQ(by_scheme(Preset::paper, own), own);
  EXPECT_EQ(under(own, project), project);
  EXPECT_EQ(under(by_scheme(Preset::talus, own), project).solver, SolverSettings{});
}

TEST(Setting, SurvivesItsJson) {
  Setting setting{BodyKind::affine, Strain::incremental, Integrator::generalized_alpha, 0.3, 0.7, 1.7, 1e-4};
  EXPECT_EQ(setting_of(setting_json(setting)), setting);
  setting.body.reset();
  setting.penetration_tolerance.reset();
  setting.scheme = Preset::paper;
  setting.contact = ContactModel::facet_wise;
  setting.contact_stiffness = 2;
  EXPECT_EQ(setting_of(setting_json(setting)), setting);
  nlohmann::ordered_json old = setting_json(Setting{});
  old.erase("scheme");
  EXPECT_EQ(setting_of(old), Setting{}) << "studies made before there were schemes";
}

}  // namespace
}  // namespace talus
