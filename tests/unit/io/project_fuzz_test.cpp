#include <random>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "unit/io/sample_project.hpp"

/// Texts and projects changed at random, always the same ones: a text either is a project or an InputError, and what
/// is saved over a commented text reads back as it was.
namespace talus {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t limit) { return random() % limit; }

std::string mutated(std::string text, Random& random) {
  static const std::vector<std::string> pieces{"{",
                                               "}",
                                               "[",
                                               "]",
                                               ",",
                                               ":",
                                               "\"",
                                               "//",
                                               "/*",
                                               "*/",
                                               "\n",
                                               "\\",
                                               "null",
                                               "true",
                                               "-",
                                               "1e999",
                                               "NaN",
                                               "0",
                                               "-1",
                                               "1e-400",
                                               "\"box\": ",
                                               "\"name\": \"x\"",
                                               "\"rigid\"",
                                               "\"auto\"",
                                               "\"stress\": true",
                                               "\xFF",
                                               "\xE2",
                                               std::string(1, '\0'),
                                               "\r",
                                               "[[[[",
                                               "{}",
                                               "0.5",
                                               "\"slope\"",
                                               "99999999999999999999",
                                               "\"\\u0000\"",
                                               "\"\\ud800\""};
  for (std::size_t changes = below(random, 3) ? 1 : 3; changes > 0; --changes) {
    const std::size_t at = below(random, text.size());
    switch (below(random, 5)) {
      case 0:
        text.erase(at, 1 + below(random, 8));
        break;
      case 1:
        text.insert(at, pieces[below(random, pieces.size())]);
        break;
      case 2:
        text[at] = static_cast<char>(below(random, 256));
        break;
      case 3:
        text.insert(at, text.substr(below(random, text.size()), below(random, 60)));
        break;
      default:
        text.replace(at, below(random, 12), pieces[below(random, pieces.size())]);
        break;
    }
    if (text.empty()) text = " ";
  }
  return text;
}

TEST(ProjectFuzz, EveryTextIsAProjectOrAnInputError) {
  Random random(20240605);
  int projects = 0;
  constexpr int texts = 6000;
  for (int i = 0; i < texts; ++i) {
    const std::string text = mutated(i % 2 ? test::full_project : test::small_project, random);
    try {
      const Project project = parse_project(text);
      ++projects;
      ASSERT_EQ(parse_project(write_project(project)), project) << text;
      ASSERT_EQ(write_project(project, text), text);
    } catch (const InputError& error) {
      ASSERT_FALSE(error.place().empty()) << text;
      ASSERT_FALSE(error.problem().empty()) << text;
      ASSERT_FALSE(error.remedy().empty()) << error.what();
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << text;
    }
  }
  // Most mutations break a project, those inside comments and numbers do not: both paths were walked.
  EXPECT_GT(projects, texts / 30);
  EXPECT_LT(projects, texts / 2);
}

/// Sprinkles comments and line ends between the tokens of a project.
std::string commented(const std::string& text, Random& random) {
  static const std::vector<std::string> blanks{" // a, \"b\" {\n", "/* c */", "\n", "/* d\n e */", "  ",
                                               " // */\n",         "\t"};
  std::string out;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "//") == 0 && !in_string) i = text.find('\n', i);
    if (text.compare(i, 2, "/*") == 0 && !in_string) i = text.find("*/", i) + 2;
    const bool token = !in_string && std::string_view("{}[],:").find(text[i]) != std::string_view::npos;
    if (token && below(random, 4) == 0) out += blanks[below(random, blanks.size())];
    out += text[i];
    if (token && below(random, 4) == 0) out += blanks[below(random, blanks.size())];
    if (text[i] == '\\')
      out += text[++i];
    else if (text[i] == '"')
      in_string = !in_string;
  }
  return out;
}

template <typename Things>
void shuffle_some(Things& things, Random& random) {
  if (things.empty()) return;
  const std::size_t a = below(random, things.size()), b = below(random, things.size());
  switch (below(random, 4)) {
    case 0:
      std::swap(things[a], things[b]);
      break;
    case 1:
      things.insert(things.begin() + static_cast<std::ptrdiff_t>(a), things[b]);
      break;
    case 2:
      things.erase(things.begin() + static_cast<std::ptrdiff_t>(a));
      break;
    default:
      break;
  }
}

Project changed(Project project, Random& random) {
  for (std::size_t changes = 1 + below(random, 5); changes > 0; --changes) {
    switch (below(random, 16)) {
      case 0:
        project.gravity[static_cast<Eigen::Index>(below(random, 3))] = 0.1 * static_cast<double>(random());
        break;
      case 1:
        shuffle_some(project.cuts, random);
        break;
      case 2:
        shuffle_some(project.loads, random);
        break;
      case 3:
        shuffle_some(project.velocities, random);
        break;
      case 4:
        std::swap(project.materials[0], project.materials[1]);
        break;
      case 5:
        project.solids[0].shape = FileShape{"a.step", 2};
        break;
      case 6:
        shuffle_some(project.expect, random);
        break;
      case 7:
        project.joints[0].cohesion = static_cast<double>(random());
        break;
      case 8:
        project.output.every = 0.1;
        break;
      case 9:
        shuffle_some(project.constraints, random);
        break;
      case 10:
        shuffle_some(project.in_situ, random);
        break;
      case 11:
        project.loads.push_back({"top", {5, 5, 10}, {0, 0, 0}, {{0.5, {0, 1, 0}}, {1.5, {0, 0, -1}}}});
        break;
      case 12:
        std::swap(project.stages[1].joints[0], project.stages[1].joints[1]);
        project.stages[1].joints[0].cohesion = static_cast<double>(random());
        break;
      case 13:
        project.stages[below(random, 2)].loads = project.loads;
        break;
      case 14:
        project.stages[below(random, 2)].constraints.reset();
        break;
      default:
        project.name = below(random, 2) ? "" : "another // name";
        break;
    }
  }
  return project;
}

TEST(ProjectFuzz, WhatIsSavedOverACommentedTextReadsBackTheSame) {
  Random random(7);
  for (int i = 0; i < 1500; ++i) {
    const std::string text = commented(test::full_project, random);
    const Project before = parse_project(text);
    ASSERT_EQ(write_project(before, text), text);
    const Project after = changed(before, random);
    const std::string written = write_project(after, text);
    ASSERT_EQ(parse_project(written), after) << text << "\n-----\n" << written;
  }
}

}  // namespace
}  // namespace talus
