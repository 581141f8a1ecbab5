#include <gmock/gmock.h>

#include <ctime>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "unit/io/sample_project.hpp"

namespace talus {
namespace {

using test::small_project;
using testing::HasSubstr;

/// `what` in the small project becomes `with`.
struct BadText {
  std::string what, with;
  std::string place, problem, remedy;
};

std::ostream& operator<<(std::ostream& out, const BadText& bad) { return out << bad.what << " -> " << bad.with; }

void expect_refused(const std::string& text, const BadText& bad) {
  try {
    parse_project(text);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), bad.place);
    EXPECT_THAT(error.problem(), HasSubstr(bad.problem));
    EXPECT_THAT(error.remedy(), HasSubstr(bad.remedy));
    EXPECT_THAT(std::string(error.what()), testing::Not(HasSubstr("\n")));
  }
}

class BadProject : public testing::TestWithParam<BadText> {};

TEST_P(BadProject, SaysLineProblemAndRemedy) {
  expect_refused(test::replaced(small_project, GetParam().what, GetParam().with), GetParam());
}

const std::vector<BadText> not_json{
    {"\"talus\": 1,", "\"talus\": 1", "line 3, column 3", "a comma is missing before this text", "comma"},
    {"0.24}", "0.24,}", "line 4, column 62", "comma stands before the closing '}'", "remove the comma"},
    {"[5, 5, 5]", "[5, 5, 5", "line 15, column 73", "not JSON: unexpected '}'", "bracket"},
    {"\"rock\":", "rock:", "line 4, column 5", "not JSON", "quote"},
    {"2600", "NaN", "line 4, column 25", "'NaN' is not a number", "finite number"},
    {"2600", "-Infinity", "line 4, column 25", "'-Infinity' is not a number", "finite number"},
    {"2600", "1e999", "line 4, column 25", "1e999 is too large", "1.8e308"},
    {"2600", "-1e999", "line 4, column 25", "-1e999 is too large", "1.8e308"},
    {"\"young\"", "\"density\"", "line 4, column 31", "'density' is given twice", "one of the two"},
    {"\"J2\": {", "\"J1\": {", "line 8, column 5", "'J1' is given twice", "one of the two"},
    {"  ]\n}\n", "  ]\n", "line 20, column 1", "ends before the project does", "close"},
    {"\"slide\"", "\"sl\\u0000ide\"", "line 18, column 17", "\\u0000 stands in a text", "remove it"},
    {"2600", std::string(500, '9'), "line 4, column 25", std::string(40, '9') + " is too large", "1.8e308"},
    {"\"slide\"", "\"sl\xFFide\"", "line 18, column 14", "not JSON", ""},
};
INSTANTIATE_TEST_SUITE_P(NotJson, BadProject, testing::ValuesIn(not_json));

const std::vector<BadText> against_schema{
    {"\"talus\": 1,", "\"talus\": 2,", "line 2, /talus", "version is 2, and this program understands version 1", "1"},
    {"\"talus\": 1,", "\"talus\": \"1\",", "line 2, /talus", "version is \"1\"", "\"talus\": 1"},
    {"\"talus\": 1,", "", "line 1, /", "no \"talus\" key", "begin the file"},
    {"\"density\"", "\"densty\"", "line 4, /materials/rock/densty", "'densty' is not known here",
     "did you mean 'density'?"},
    {"\"stages\"", "\"steges\"", "line 17, /steges", "'steges' is not known", "did you mean 'stages'?"},
    {"\"friction_angle\": 8", "\"mu\": 0.1, \"friction_angle\": 8", "line 8, /joints/J2/mu", "'mu' is not known",
     "use one of"},
    {"\"density\": 2600, ", "", "line 4, /materials/rock", "'density' is missing", "kg/m³"},
    {"\"density\": 2600", "\"density\": -2600", "line 4, /materials/rock/density", "must be greater than 0, is -2600",
     "kg/m³"},
    {"0.24", "0.5", "line 4, /materials/rock/poisson", "must be below 0.5, is 0.5", "0.1 to 0.35"},
    {"0.24", "-1", "line 4, /materials/rock/poisson", "must be greater than -1, is -1", "Poisson"},
    {"0.24", "0.24, \"strength\": {\"cohesion\": 1e6}", "line 4, /materials/rock/strength",
     "'friction_angle' is missing", "degrees"},
    {"0.24", "0.24, \"strength\": {\"cohesion\": -1, \"friction_angle\": 45}",
     "line 4, /materials/rock/strength/cohesion", "must be at least 0, is -1", "Pa"},
    {"25e9", "\"25e9\"", "line 4, /materials/rock/young", "must be a number, is \"25e9\"", "Pa"},
    {"25e9", "null", "line 4, /materials/rock/young", "must be a number, is null", "Pa"},
    {"\"friction_angle\": 8", "\"friction_angle\": 90", "line 8, /joints/J2/friction_angle", "must be below 90, is 90",
     "degrees"},
    {"\"time_step\": 0.01", "\"time_step\": 0", "line 18, /stages/0/time_step", "must be greater than 0, is 0",
     "time step, s"},
    {"\"steps\": 100", "\"steps\": 1.5", "line 18, /stages/0/steps", "must be a whole number, is 1.5",
     "number of time steps"},
    {"\"steps\": 100", "\"steps\": 99999999999999999999", "line 18, /stages/0/steps", "must be a whole number",
     "steps"},
    {"\"steps\": 100", "\"duration\": 1e300", "line 18, /stages/0/duration", "more than 2147483647 steps", "shorten"},
    {"\"steps\": 100", "\"steps\": 3000000000", "line 18, /stages/0/steps", "must be at most 2147483647", "steps"},
    {"\"steps\": 100", "\"steps\": 100, \"duration\": 1", "line 18, /stages/0",
     "'steps' and 'duration' are given together", "exactly one"},
    {", \"steps\": 100", "", "line 18, /stages/0", "none of 'steps', 'duration' is given", "exactly one"},
    {"\"dynamic\"", "\"dynamik\"", "line 18, /stages/0/type", "\"dynamik\" is not known here",
     "did you mean 'dynamic'?"},
    {"[5, 5, 5]", "[5, 5]", "line 15, /cuts/0/through", "must have 3 entries, has 2", "[x, y, z]"},
    {"[5, 5, 5]", "[5, \"5\", 5]", "line 15, /cuts/0/through/1", "must be a number, is \"5\"", "coordinate"},
    {"\"dip\": 35", "\"dip\": 95", "line 15, /cuts/0/dip", "must be at most 90, is 95", "horizontal"},
    {"\"dip\": 35", "\"dip\": 35, \"spacing\": 2", "line 15, /cuts/0", "'spacing' is given without 'count'", "add it"},
    {"\"box\": {", "\"bax\": {", "line 12, /solids/0/bax", "'bax' is not known", "did you mean 'box'?"},
    {"\"box\": {", "\"file\": \"a.step\", \"box\": {", "line 12, /solids/0", "'box' and 'file' are given together",
     "exactly one"},
    {"\"material\": \"rock\"", "\"material\": \"rock\", \"scale\": 2", "line 12, /solids/0",
     "'scale' is given without 'file'", "STEP"},
    {"\"name\": \"slope\"", "\"name\": \"\"", "line 12, /solids/0/name", "is empty", "a name"},
    {"\"stages\": [\n    {\"name\": \"slide\", \"type\": \"dynamic\", \"time_step\": 0.01, \"steps\": 100}\n  ]",
     "\"stages\": []", "line 17, /stages", "must have at least 1 entries, has 0", "what is run"},
    {"\"default_joint\": \"J1\"", "\"default_joint\": \"J1\", \"cuts \": []", "line 10, /cuts ", "'cuts ' is not known",
     "did you mean 'cuts'?"},
};
INSTANTIATE_TEST_SUITE_P(AgainstSchema, BadProject, testing::ValuesIn(against_schema));

const std::vector<BadText> against_rules{
    {"0.24", "0.24, \"strength\": {\"cohesion\": 1e6, \"friction_angle\": 45, \"tensile_strength\": 1.1e6}",
     "line 4, /materials/rock/strength/tensile_strength", "beyond the apex", "leave it out"},
    {"\"joint\": \"J2\"", "\"joint\": \"X7\"", "line 15, /cuts/0/joint", "joint 'X7' is used here but not defined",
     "define it under joints, or use one of J1, J2"},
    {"\"material\": \"rock\"", "\"material\": \"rok\"", "line 12, /solids/0/material", "material 'rok' is not defined",
     "did you mean 'rock'?"},
    {"\"max\": [10, 10, 10]", "\"max\": [10, 0, 10]", "line 12, /solids/0/box/max/1", "greater than min", "swap"},
    {"\"default_joint\": \"J1\",", "", "line 1, /default_joint", "no joint is named", "one of the joints"},
    {"\"box\": {\"min\": [0, 0, 0], \"max\": [10, 10, 10]}",
     "\"polyhedron\": {\"vertices\": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]],\n \"faces\": "
     "[[0,1,2],[0,3,1],[1,3,2],[0,2,3]]}",
     "line 12, /solids/0/polyhedron", "inside out", "reverse"},
    {"\"box\": {\"min\": [0, 0, 0], \"max\": [10, 10, 10]}",
     "\"polyhedron\": {\"vertices\": [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[2,2,2]],\n"
     " \"faces\": [[0,2,1],[0,1,3],\n[1,2,4],[0,3,2]]}",
     "line 13, /solids/0/polyhedron/faces/1", "open: no other face joins edge 1–3", "missing face"},
    {"\"box\": {\"min\": [0, 0, 0], \"max\": [10, 10, 10]}", "\"file\": \"../hill.step\"", "line 12, /solids/0/file",
     "'../hill.step' lies outside the project's folder", "--allow-outside"},
    {"\"box\": {\"min\": [0, 0, 0], \"max\": [10, 10, 10]}", "\"file\": \"/etc/hill.step\"", "line 12, /solids/0/file",
     "outside", "--allow-outside"},
    {"\"box\": {\"min\": [0, 0, 0], \"max\": [10, 10, 10]}", "\"file\": \"a/../../hill.step\"",
     "line 12, /solids/0/file", "outside", "--allow-outside"},
};
INSTANTIATE_TEST_SUITE_P(AgainstRules, BadProject, testing::ValuesIn(against_rules));

/// `list` is added to the small project.
BadText added(const std::string& list, const std::string& place, const std::string& problem,
              const std::string& remedy) {
  return {"\"default_joint\"", list + ", \"default_joint\"", "line 10, " + place, problem, remedy};
}

const std::vector<BadText> actions{
    added(R"("constraints": [{"block": "slope.1", "at": [0, 0, 0]}])", "/constraints/0",
          "none of 'displacement', 'table' is given", "exactly one"),
    added(
        R"("constraints": [{"block": "slope.1", "at": [0, 0, 0], "displacement": [0, 0, 0], "table": [[0, 1, 1, 1]]}])",
        "/constraints/0", "'displacement' and 'table' are given together", "exactly one"),
    added(R"("constraints": [{"block": "slope.1", "at": [0, 0, 0], "table": []}])", "/constraints/0/table",
          "at least 1 entries", "rows [t, x, y, z]"),
    added(R"("constraints": [{"block": "slope.1", "at": [0, 0, 0], "table": [[0, 0, 0, 0], [0, 1, 1, 1]]}])",
          "/constraints/0/table/1/0", "times of a table must ascend, and 0 s follows 0 s", "sort the rows"),
    added(R"("constraints": [{"block": "slope.1", "at": [0, 0, 0], "table": [[null, 0, 0, 0]]}])",
          "/constraints/0/table/0/0", "not a finite number", "finite number"),
    added(R"("constraints": [{"block": "slope.1", "at": [0, 0, 0], "table": [[0, 0, 0, 0], [1, 0, null, 0]]}])",
          "/constraints/0/table/1/2", "is no number here, and one in another row", "null in every row"),
    added(R"("constraints": [{"block": "slope.1", "at": [0, 0, 0], "table": [[0, null, null, null]]}])",
          "/constraints/0/table", "holds nothing", "at least one component"),
    added(R"("constraints": [{"block": "slope.1", "displacement": [0, 0, 0]}])", "/constraints/0",
          "moves block 'slope.1' as a whole, which is not fixed", "add the point 'at'"),
    added(R"("loads": [{"block": "slope.1", "at": [0, 0, 0]}])", "/loads/0", "none of 'force', 'table' is given",
          "exactly one"),
    added(R"("loads": [{"block": "slope.1", "at": [0, 0, 0], "force": [0, 0, 0], "table": [[0, 1, 1, 1]]}])",
          "/loads/0", "'force' and 'table' are given together", "exactly one"),
    added(R"("loads": [{"block": "slope.1", "at": [0, 0, 0], "table": [[0, 1]]}])", "/loads/0/table/0",
          "must have 4 entries, has 2", "a row [t, x, y, z]"),
    added(R"("loads": [{"block": "slope.1", "at": [0, 0, 0], "table": [[0, 1, 1, null]]}])", "/loads/0/table/0/3",
          "must be a number, is null", "force, N"),
    added(R"("loads": [{"block": "slope.1", "at": [0, 0, 0], "table": [[2, 0, 0, 0], [1, 1, 1, 1]]}])",
          "/loads/0/table/1/0", "1 s follows 2 s", "sort the rows"),
    added(R"("in_situ": [{"gradient": [0, 0, 0, 0, 0, 0]}])", "/in_situ/0", "'stress' is missing", "Pa"),
    added(R"("in_situ": [{"stress": [0, 0, 0]}])", "/in_situ/0/stress", "must have 6 entries, has 3", "xx, yy, zz"),
    added(R"("in_situ": [{"stress": [0, 0, 0, 0, 0, 0], "blocks": ["slop"]}])", "/in_situ/0/blocks/0",
          "nothing is called 'slop'", "did you mean 'slope'?"),
    {"\"poisson\": 0.24", "\"poisson\": 0.24, \"damping\": -1", "line 4, /materials/rock/damping",
     "must be at least 0, is -1", "1/s"},
};
INSTANTIATE_TEST_SUITE_P(Actions, BadProject, testing::ValuesIn(actions));

/// `keys` are added to the small project's dynamic stage.
BadText staged(const std::string& keys, const std::string& place, const std::string& problem,
               const std::string& remedy) {
  return {"\"steps\": 100", "\"steps\": 100, " + keys, "line 18, /stages/0" + place, problem, remedy};
}

const std::vector<BadText> stages{
    staged(R"("until_equilibrium": true)", "/until_equilibrium", "a dynamic stage does not end at equilibrium",
           "make the stage static"),
    staged(R"("until_equilibrium": 1)", "/until_equilibrium", "must be true or false, is 1", "nothing moves"),
    staged(R"("equilibrium_tolerance": 1e-3)", "/equilibrium_tolerance", "does not ask for equilibrium",
           "\"until_equilibrium\": true"),
    staged(R"("equilibrium_tolerance": 0)", "/equilibrium_tolerance", "greater than 0, is 0", "1e-5"),
    staged(R"("damping": -1)", "/damping", "at least 0, is -1", "1/s"),
    staged(R"("joints": {"J3": {"cohesion": 0}})", "/joints/J3", "joint 'J3' is used here but not defined",
           "use one of J1, J2"),
    staged(R"("joints": {"J1": {}})", "/joints/J1", "changes nothing", "friction_angle"),
    staged(R"("joints": {"J1": {"normal_stiffness": 1e9}})", "/joints/J1/normal_stiffness", "is not known here",
           "use one of"),
    staged(R"("joints": {"J1": {"residual_friction_angle": 31}})", "/joints/J1/residual_friction_angle",
           "the residual friction angle, 31°, exceeds the friction angle, 30°", "at most"),
    staged(R"("loads": [{"block": "slip", "at": [0, 0, 0], "force": [0, 0, 0]}])", "/loads/0/block",
           "nothing is called 'slip'", "slope"),
    staged(R"("constraints": [{"block": "slip", "at": [0, 0, 0], "displacement": [0, 0, 0]}])", "/constraints/0/block",
           "nothing is called 'slip'", "slope"),
    staged(R"("constraints": [{"block": "slope.1", "displacement": [0, 0, 0]}])", "/constraints/0",
           "moves block 'slope.1' as a whole", "'fixed'"),
    staged(R"("blocks": [{"name": "slope.1"}])", "/blocks/0", "'body' is missing", "built as"),
    staged(R"("blocks": [{"name": "slip", "body": "fixed"}])", "/blocks/0/name", "nothing is called 'slip'", "slope"),
    staged(R"("blocks": [{"name": "slope.1", "body": "rigid"}])", "/blocks/0/body",
           "is built as 'tetrahedra' and cannot become 'rigid'", "'fixed' to hold it, or 'tetrahedra'"),
    staged(R"("blocks": [{"name": "slope.1", "body": "fixed"}, {"name": "slope.1", "body": "tetrahedra"}])",
           "/blocks/1/name", "'slope.1' is changed twice in this stage", "keep one"),
};
INSTANTIATE_TEST_SUITE_P(Stages, BadProject, testing::ValuesIn(stages));

BadText solved(const std::string& keys, const std::string& place, const std::string& problem,
               const std::string& remedy) {
  return added("\"solver\": {" + keys + "}", "/solver" + place, problem, remedy);
}

const std::vector<BadText> solver{
    solved(R"("strain": "corotatonal")", "/strain", "\"corotatonal\" is not known", "did you mean 'corotational'?"),
    solved(R"("spectral_radius": 0.5)", "/spectral_radius", "'newmark' has no spectral radius", "generalized-alpha"),
    solved(R"("integrator": "generalized-alpha", "spectral_radius": 1.5)", "/spectral_radius", "at most 1, is 1.5",
           "damps most"),
    solved(R"("contact": "points")", "/contact", "\"points\" is not known", "use one of"),
    solved(R"("penetration_tolerance": 0)", "/penetration_tolerance", "greater than 0, is 0", "mesh size"),
    solved(R"("tolerance": 0)", "/tolerance", "at least 1e-12, is 0", "standard (1e-6, when absent)"),
    solved(R"("tolerance": 0.5)", "/tolerance", "at most 0.01, is 0.5", "standard (1e-6, when absent)"),
    solved(R"("tolerance": "standart")", "/tolerance", "\"standart\" is not known", "did you mean 'standard'?"),
    solved(R"("tolerance": true)", "/tolerance", "must be a number or a text in quotes, is true",
           "standard (1e-6, when absent)"),
    solved(R"("time_step_control": "adaptiv")", "/time_step_control", "\"adaptiv\" is not known",
           "did you mean 'adaptive'?"),
    solved(R"("adaptive": {"iterations": 5})", "/adaptive", "the steps are fixed",
           "\"time_step_control\": \"adaptive\""),
    solved(R"("time_step_control": "adaptive", "adaptive": {"shortest": 2})", "/adaptive/shortest", "at most 1, is 2",
           "time_step"),
    solved(R"("time_step_control": "adaptive", "adaptive": {"limit": 2})", "/adaptive/limit", "'limit' is not known",
           "use one of"),
};
INSTANTIATE_TEST_SUITE_P(Solver, BadProject, testing::ValuesIn(solver));

TEST(BadText, OtherKindsOfText) {
  expect_refused("", {"", "", "line 1", "empty", "begins with"});
  expect_refused("  // nothing\n", {"", "", "line 1", "empty", "begins with"});
  expect_refused("[]", {"", "", "line 1, /", "not a Talus project", "begin the file"});
  expect_refused("1", {"", "", "line 1, /", "not a Talus project", "begin the file"});
  expect_refused(small_project + "x", {"", "", "line 21, column 1", "not JSON", ""});
  expect_refused(std::string("{\"talus\": 1}\0", 13), {"", "", "line 1, column 13", "zero byte", "UTF-8"});
  expect_refused(std::string(100000, '['), {"", "", "the text", "nested deeper than 64", "brackets"});
}

TEST(BadText, PathsMayLeaveTheFolderWhenAllowed) {
  const std::string text = test::replaced(small_project, "\"box\": {\"min\": [0, 0, 0], \"max\": [10, 10, 10]}",
                                          "\"file\": \"../hill.step\"");
  EXPECT_EQ(std::get<FileShape>(parse_project(text, {.allow_outside = true}).solids[0].shape).path, "../hill.step");
}

TEST(BadProjects, AListThatIsWrongInEveryEntryIsToldAtOnce) {
  std::string list;
  for (int i = 0; i < 100000; ++i) list += i == 0 ? "[[]" : ",[]";
  const BadText bad{"[5, 5, 5]", list + "]", "line 15, /cuts/0/through", "must have 3 entries", "expected"};
  const std::clock_t begin = std::clock();
  expect_refused(test::replaced(small_project, bad.what, bad.with), bad);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10) << "was over a minute";
}

TEST(BadProjects, ANumberBeyondWholeNumbersIsANumber) {
  const Project project = parse_project(test::replaced(small_project, "2600", "9223372036854775808"));
  EXPECT_EQ(project.materials.at(0).density, 9223372036854775808.0);
}

}  // namespace
}  // namespace talus
