#include "templates/templates.hpp"

#include <gmock/gmock.h>

#include <set>

#include "base/error.hpp"
#include "io/project_file.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

/// What `project_from` complains of; empty when it does not.
std::string complaint(const ProjectTemplate& chosen, const TemplateValues& values) {
  try {
    project_from(chosen, values);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Every number at each of its ends, the others as they are preset; and all at one end.
std::vector<TemplateValues> ends_of(const ProjectTemplate& chosen) {
  std::vector<TemplateValues> ends(2);
  for (const TemplateNumber& number : chosen.numbers) {
    ends.push_back({{number.key, number.least}});
    ends.push_back({{number.key, number.most}});
    ends[0][number.key] = number.least;
    ends[1][number.key] = number.most;
  }
  return ends;
}

TEST(Templates, SevenAskForFiveNumbersEach) {
  EXPECT_EQ(project_templates().size(), 7U);
  std::set<std::string> keys;
  for (const ProjectTemplate& candidate : project_templates()) {
    EXPECT_TRUE(keys.insert(candidate.key).second) << candidate.key;
    EXPECT_EQ(candidate.numbers.size(), 5U) << candidate.key;
    EXPECT_FALSE(candidate.description.empty());
    for (const TemplateNumber& number : candidate.numbers) {
      EXPECT_LT(number.least, number.most) << number.key;
      EXPECT_GE(number.preset, number.least) << number.key;
      EXPECT_LE(number.preset, number.most) << number.key;
      EXPECT_FALSE(number.name.empty() || number.meaning.empty()) << number.key;
      EXPECT_EQ(number.unit.empty(), number.whole) << number.key << ": a length or an angle has a unit";
    }
  }
}

TEST(Templates, MakeProjectsThatAreReadBackAtTheEndsOfTheirRanges) {
  for (const ProjectTemplate& chosen : project_templates()) {
    std::vector<TemplateValues> all = ends_of(chosen);
    all.push_back({});
    for (const TemplateValues& values : all) {
      const Project project = project_from(chosen, values);
      ASSERT_NO_THROW(EXPECT_EQ(parse_project(write_project(project)), project) << chosen.key) << chosen.key;
    }
  }
}

TEST(Templates, FollowEveryNumber) {
  for (const ProjectTemplate& chosen : project_templates()) {
    const Project preset = project_from(chosen);
    for (const TemplateNumber& number : chosen.numbers) {
      const double other = number.preset == number.most ? number.least : number.most;
      EXPECT_NE(project_from(chosen, {{number.key, other}}), preset) << chosen.key << ' ' << number.key;
    }
  }
}

TEST(Templates, SayWhichNumberIsOutOfItsRange) {
  const ProjectTemplate& wedge = template_named("wedge");
  EXPECT_THAT(complaint(wedge, {{"plunge", 51}}), HasSubstr("Plunge ψ: must be 20 to 50 °, is 51"));
  EXPECT_EQ(complaint(wedge, {{"plunge", 50}}), "");
  EXPECT_THAT(complaint(wedge, {{"plunge", std::numeric_limits<double>::quiet_NaN()}}), HasSubstr("is nan"));
  EXPECT_THAT(complaint(wedge, {{"plung", 40}}), HasSubstr("did you mean 'plunge'?"));
  EXPECT_THAT(complaint(template_named("dry-stone-wall"), {{"courses", 2.5}}),
              HasSubstr("Courses: is a count, not 2.5"));
}

TEST(Templates, AreFoundByTheirNames) {
  EXPECT_EQ(template_named("cavern").name, "Cavern");
  try {
    template_named("caverm");
    FAIL() << "there is no such template";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'cavern'?"));
  }
}

}  // namespace
}  // namespace talus
