#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "document/schema.hpp"

namespace talus::schema {
namespace {

using testing::IsEmpty;

/// A unit that the project keeps, and one that a field of it shows.
using Units = std::pair<std::string, std::string>;

void collect(const Json& rule, std::set<Units>& found) {
  if (rule.is_object()) {
    const std::string kept = rule.value("unit", std::string());
    if (!kept.empty()) found.emplace(kept, rule.value("shown", kept));
    const Json units = rule.value("units", Json::array()), shown = rule.value("shownUnits", units);
    for (std::size_t i = 0; i < units.size(); ++i) found.emplace(units.at(i), shown.at(i));
  }
  for (const auto& inner : rule)
    if (inner.is_structured()) collect(inner, found);
}

TEST(SchemaUnits, OfEveryFieldCanBeTypedAndShown) {
  std::set<Units> all;
  collect(root(), all);
  EXPECT_GT(all.size(), 12u);
  for (const auto& [kept, shown] : all) {
    EXPECT_NO_THROW(EXPECT_EQ(read_quantity("1 " + kept, kept, shown), 1)) << kept;
    EXPECT_NO_THROW(EXPECT_GT(read_quantity("1", kept, shown), 0)) << shown << " for " << kept;
  }
}

TEST(SchemaUnits, OfAnotherKindAreRefusedWithWhatIsWanted) {
  std::set<Units> all;
  collect(root(), all);
  std::vector<std::string> silent;
  for (const auto& [kept, shown] : all) try {
      read_quantity("1 mol", kept, shown);
      silent.push_back(kept);
    } catch (const InputError& error) {
      if (error.remedy().empty()) silent.push_back(kept);
    }
  EXPECT_THAT(silent, IsEmpty());
}

TEST(SchemaWords, ARuleKnowsTheDefinitionThatItRefersTo) {
  EXPECT_EQ(ruleOf(Place("/loads/0/at")).value("of", std::string()), "at");
  EXPECT_EQ(ruleOf(Place("/solids/0/move")).value("of", std::string()), "vector");
  EXPECT_EQ(ruleOf(Place("/loads/0/block")).value("of", std::string()), "block_name");
  EXPECT_EQ(ruleOf(Place("/output/every")).value("of", std::string()), "");
}

TEST(SchemaWords, TakeThePlaceOfKeysOfTheFile) {
  EXPECT_EQ(inWordsOfForms(QStringLiteral("raise open_close_limit: 3 iterations were allowed")).toStdString(),
            "raise open–close limit: 3 iterations were allowed");
  EXPECT_EQ(inWordsOfForms(QStringLiteral("add one with a type, a time_step, and a duration")).toStdString(),
            "add one with a type, a time step, and a duration")
      << "no word is quoted among others that are not";
  EXPECT_EQ(inWordsOfForms(QStringLiteral("add 'spacing_law', \"fisher_kappa\" or a seed")).toStdString(),
            "add 'Law of spacing', 'Scatter κ' or a seed");
  EXPECT_EQ(inWordsOfForms(QStringLiteral("no block is called 'my_time_step' or x_y")).toStdString(),
            "no block is called 'my_time_step' or x_y");
}

TEST(SchemaWords, AreEnglishWithoutATranslator) {
  EXPECT_EQ(words(ruleOf(Place("/loads/0/at")), "title"), QStringLiteral("At"));
  EXPECT_EQ(words(ruleOf(Place("/loads/0/at")), "shown"), QString());
  EXPECT_EQ(withinSentence(QStringLiteral("Point load")), QStringLiteral("point load"));
  EXPECT_EQ(withinSentence(QStringLiteral("Density P32")), QStringLiteral("density P32"));
  EXPECT_EQ(withinSentence(QStringLiteral("Young E")), QStringLiteral("Young E"));
  EXPECT_EQ(choiceWords("tetrahedra"), QStringLiteral("tetrahedra"));
  EXPECT_EQ(choiceWords("called_for"), QStringLiteral("called for"));
}

}  // namespace
}  // namespace talus::schema
