#include "study/cases/case_study.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/temporary_folder.hpp"
#include "io/whole_file.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Cases : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const auto file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    replace_whole_file(file, text);
    return file;
  }
  std::filesystem::path project(const std::string& name) {
    return write(name, R"({"talus": 1, "materials": {"rock": {"density": 2600, "young": 1e9,
      "poisson": 0.2}}, "joints": {"J": {"friction_angle": 30}}, "default_joint": "J", "solids": [{"name": "cube",
      "box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "material": "rock", "mesh_size": 1}],
      "stages": [{"name": "fall", "type": "dynamic", "time_step": 0.01, "steps": 2}]})");
  }
  CasePlan plan_with(const std::string& table) {
    return make_case_plan({.projects = {project("p.talus")}, .table = write("t.csv", table)});
  }
  std::string refusal_of(const std::string& table) {
    try {
      plan_with(table);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  const TemporaryFolder folder_;
};

TEST_F(Cases, OfAFolderAreItsProjectsButWhatTalusWrote) {
  project("slopes/north/a.talus"), project("slopes/south/a.talus"), project("slopes/a.results/project.talus");
  const CasePlan plan = make_case_plan({.projects = {folder_.path() / "slopes"}});
  ASSERT_EQ(plan.cases.size(), 2u);
  EXPECT_EQ(plan.cases[0].name, "north/a");
  EXPECT_EQ(plan.cases[1].name, "south/a");
  std::filesystem::create_directory(folder_.path() / "empty");
  EXPECT_THROW(make_case_plan({.projects = {folder_.path() / "empty"}}), InputError);
}

TEST_F(Cases, SayLineAndColumnOfAValueThatTheProjectCannotHave) {
  const std::string file = (folder_.path() / "t.csv").string();
  EXPECT_THAT(refusal_of("/joints/J/friction_angle\n30\n95\n"),
              testing::StartsWith(file + ": line 3, column /joints/J/friction_angle: must be below 90"));
  EXPECT_THAT(refusal_of("/solids/cube/mesh_size\n-1\n"),
              testing::StartsWith(file + ": line 2, column /solids/cube/mesh_size: must be greater than 0"));
  EXPECT_THAT(refusal_of("/joints/K/friction_angle\n30\n"),
              testing::StartsWith(file + ": column /joints/K/friction_angle: the project has no 'K'"));
  const auto two = std::vector{project("p.talus"), project("q.talus")};
  EXPECT_THROW(make_case_plan({.projects = two, .table = folder_.path() / "t.csv"}), InputError);
}

TEST_F(Cases, GoOnBehindThoseThatThereWere) {
  const std::string two = "/joints/J/friction_angle\n30\n25\n";
  const auto where = folder_.path() / "study";
  const CaseFolder first(where, plan_with(two), false);
  replace_whole_file(first.run_file(0), case_findings_text({"completed", "", {}}));
  EXPECT_THAT(CaseFolder(where, plan_with(two + "20\n"), false).missing_runs(), ElementsAre(1, 2));
  EXPECT_EQ(CaseFolder(where).plan().cases.size(), 3u);
  EXPECT_THROW(CaseFolder(where, plan_with(two), false), InputError);  // fewer
  EXPECT_THROW(CaseFolder(where, plan_with("/joints/J/friction_angle\n31\n25\n20\n"), false), InputError);
  EXPECT_THAT(CaseFolder(where, plan_with(two), true).missing_runs(), ElementsAre(0, 1));
}

TEST_F(Cases, AreOneTableWithWhatTheySayTogether) {
  const CaseFolder folder(folder_.path() / "study",
                          plan_with("case,/joints/J/friction_angle\na,30\nb,25\n\"c,d\",20\ne,10\n"), false);
  replace_whole_file(folder.run_file(0), case_findings_text({"completed", "", {{"front", 1}, {"blocks", 4}}}));
  replace_whole_file(folder.run_file(1), case_findings_text({"completed", "", {{"front", 3}}}));
  replace_whole_file(folder.run_file(2), case_findings_text({"not-converged", "J, \"J\"", {{"front", 100}}}));
  const CaseStudy study = evaluate_cases(folder);
  EXPECT_EQ(study.missing(), 1);
  ASSERT_EQ(study.statistics.size(), 2u);
  EXPECT_EQ(study.statistics[0].count, 2) << "a run that did not converge says nothing";
  EXPECT_DOUBLE_EQ(study.statistics[0].mean, 2);
  EXPECT_DOUBLE_EQ(study.statistics[0].deviation, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(study.statistics[0].p90, 2.8);
  const std::string p = (folder_.path() / "p.talus").string();
  EXPECT_EQ(cases_csv(study),
            "case,project,status,/joints/J/friction_angle,front,blocks,reason\n"
            "a," +
                p +
                ",completed,30,1,4,\n"
                "b," +
                p +
                ",completed,25,3,,\n"
                "\"c,d\"," +
                p +
                ",not-converged,20,100,,\"J, \"\"J\"\"\"\n"
                "e," +
                p + ",missing,10,,,\n");
  EXPECT_THAT(cases_markdown(study), HasSubstr("| front | 2 | 2 | 1.41 | 1 | 1.2 | 2 | 2.8 | 3 |"));
  const auto json = nlohmann::json::parse(cases_json(study));
  EXPECT_FALSE(json["complete"]);
  EXPECT_EQ(json["cases"][0]["values"]["/joints/J/friction_angle"], 30);
  EXPECT_EQ(json["statistics"]["front"]["median"], 2);
}

TEST_F(Cases, OfAFileThatIsDamagedAreRefusedByItsName) {
  const CaseFolder folder(folder_.path() / "study", plan_with("/joints/J/friction_angle\n30\n"), false);
  replace_whole_file(folder.run_file(0), "{");
  EXPECT_THROW(evaluate_cases(folder), InputError);
  write("study/study.json",
        R"({"kind": "cases", "cases": [{"name": "a", "project": 7, "values": [], "fingerprint": ""}]})");
  EXPECT_THROW(CaseFolder(folder_.path() / "study"), InputError);
}

TEST_F(Cases, OfADamagedPlanAreRefused) {
  CasePlan plan = plan_with("/joints/J/friction_angle\n30\n");
  plan.projects[0].text.insert(20, "[:");
  EXPECT_THROW(project_of_case(plan, 0), InputError);
  const CaseFolder folder(folder_.path() / "study", plan_with("/joints/J/friction_angle\n30\n"), false);
  std::string text = folder.read("study.json");
  text.replace(text.find("\"pointers\": ["), 13, "\"pointers\": [\"/gravity\",");
  folder.write("study.json", text);
  EXPECT_THROW(CaseFolder(folder.path()), InputError);
}

TEST(Quantiles, LieBetweenValues) {
  EXPECT_DOUBLE_EQ(quantile({1, 2, 3, 4, 5}, 0.5), 3);
  EXPECT_DOUBLE_EQ(quantile({1, 2}, 0.1), 1.1);
  EXPECT_DOUBLE_EQ(quantile({7}, 0.9), 7);
  EXPECT_DOUBLE_EQ(quantile({1, 2}, 1), 2);
}

}  // namespace
}  // namespace talus
