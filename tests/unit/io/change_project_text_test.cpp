#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/project_file.hpp"

// What a person wrote around the values survives a change of them. The texts need not be projects.
namespace talus {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const std::string& text) { return Json::parse(text, nullptr, true, true); }

/// The text once `change` has been made to its value.
template <class Change>
std::string changed(const std::string& text, Change change) {
  Json value = value_of(text);
  change(value);
  const std::string out = change_project_text(text, value.dump());
  EXPECT_EQ(value_of(out), value) << out;
  return out;
}

TEST(ChangeProjectText, OfNothingIsTheSameToTheByte) {
  const std::string text = "/* a */ {\"x\": 1.50, // b\r\n \"y\" : [ 1 , /* c */ 2 ] }\n// end";
  EXPECT_EQ(changed(text, [](Json&) {}), text);
}

TEST(ChangeProjectText, KeepsACommentBehindAComma) {
  EXPECT_EQ(changed("{\"a\": 1, // first\n \"b\": 2}", [](Json& v) { v["a"] = 7; }), "{\"a\": 7, // first\n \"b\": 2}");
  EXPECT_EQ(changed("{\"a\": 1, // first\n \"b\": 2}", [](Json& v) { v["b"] = 7; }), "{\"a\": 1, // first\n \"b\": 7}");
}

TEST(ChangeProjectText, KeepsACommentBeforeAClosingBracket) {
  EXPECT_EQ(changed("{\"a\": [1, 2 /* two */\n // the end\n]}", [](Json& v) { v["a"][0] = 9; }),
            "{\"a\": [9, 2 /* two */\n // the end\n]}");
  EXPECT_EQ(changed("{\n  \"a\": 1 // one\n  // no more\n}", [](Json& v) { v["b"] = 2; }),
            "{\n  \"a\": 1, // one\n  \"b\": 2\n  // no more\n}");
}

TEST(ChangeProjectText, KeepsCommentsInListsOfNumbersAndOfThings) {
  EXPECT_EQ(changed("[0, /* y */ 0, 1 // up\n]", [](Json& v) { v[1] = -4; }), "[0, /* y */ -4, 1 // up\n]");
  const std::string things =
      "[\n  // one\n  {\"name\": \"a\"}, // of a\n  /* two */ {\"name\": \"b\", \"x\": 1} // of b\n]";
  EXPECT_EQ(changed(things, [](Json& v) { v[1]["x"] = 2; }),
            "[\n  // one\n  {\"name\": \"a\"}, // of a\n  /* two */ {\"name\": \"b\", \"x\": 2} // of b\n]");
}

TEST(ChangeProjectText, TakesCommentsOfWhatIsRemovedAndNoOthers) {
  const std::string things =
      "[\n  // one\n  {\"name\": \"a\"}, // of a\n  // two\n  {\"name\": \"b\"} // of b\n  // foot\n]";
  EXPECT_EQ(changed(things, [](Json& v) { v.erase(1); }), "[\n  // one\n  {\"name\": \"a\"} // of a\n  // foot\n]");
  EXPECT_EQ(changed(things, [](Json& v) { v.erase(0); }), "[\n  // two\n  {\"name\": \"b\"} // of b\n  // foot\n]");
  EXPECT_EQ(changed("{\"a\": 1 /* of a */, \"b\": 2}", [](Json& v) { v.erase("a"); }), "{\"b\": 2}");
}

TEST(ChangeProjectText, KeepsCommentsBeforeAndBehindTheWhole) {
  EXPECT_EQ(changed("// head\n{\"a\": 1}\n// tail\n/* last */", [](Json& v) { v["a"] = 2; }),
            "// head\n{\"a\": 2}\n// tail\n/* last */");
}

TEST(ChangeProjectText, MovesCommentsWithTheThingsOfAList) {
  const std::string things = "[\n  // one\n  {\"name\": \"a\"},\n  // two\n  {\"name\": \"b\"}\n]";
  EXPECT_EQ(changed(things, [](Json& v) { std::swap(v[0], v[1]); }),
            "[\n  // two\n  {\"name\": \"b\"},\n  // one\n  {\"name\": \"a\"}\n]");
}

TEST(ChangeProjectText, AKeyThatIsRenamedKeepsWhatStandsInIt) {
  const std::string text =
      "{\"m\": {\n  \"ro\\\"ck\" /* grey */ : {\"young\": 25e9 /* measured */}, // best\n  \"clay\": {}\n}}";
  EXPECT_EQ(changed(text,
                    [](Json& v) {
                      v["m"] = {{"granite", {{"young", 25e9}}}, {"clay", Json::object()}};
                    }),
            "{\"m\": {\n  \"granite\" /* grey */ : {\"young\": 25e9 /* measured */}, // best\n  \"clay\": {}\n}}");
}

TEST(ChangeProjectText, KeysKeepTheirOrderAndNumbersTheirSpelling) {
  EXPECT_EQ(changed("{\"b\": 25e9, \"a\": 1.0}",
                    [](Json& v) {
                      v = {{"b", 25e9}, {"a", 1.0}, {"c", 0.1}};
                    }),
            "{\"b\": 25e9, \"a\": 1.0, \"c\": 0.1}");
}

TEST(ChangeProjectText, WhatWasEmptyHasOneThingALine) {
  EXPECT_EQ(
      changed("{\n  \"materials\": {}, // none\n  \"at\": []\n}",
              [](Json& v) {
                v["materials"]["rock"]["density"] = 2600;
                v["materials"]["marl"]["density"] = 2300;
                v["at"] = {1, 2};
              }),
      "{\n  \"materials\": {\n    \"rock\": {\"density\": 2600},\n    \"marl\": {\"density\": 2300}\n  }, // none\n"
      "  \"at\": [1, 2]\n}");
  EXPECT_EQ(changed("{\"materials\": {/* none */}}", [](Json& v) { v["materials"]["rock"] = 1; }),
            "{\"materials\": {\"rock\": 1/* none */}}");
}

TEST(ChangeProjectText, RefusesWhatIsNoJson) {
  EXPECT_THROW(change_project_text("{", "{}"), InputError);
  EXPECT_THROW(change_project_text("{}", "{"), InputError);
}

}  // namespace
}  // namespace talus
