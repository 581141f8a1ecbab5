#pragma once

#include <QString>
#include <nlohmann/json.hpp>
#include <string>

/// What a project file can say, as resources/schema has it: the forms of the window are made from it, so that it is the
/// one place that knows title, unit, default, choices and limits of a field.
///
/// Beside the words of JSON schema there are `unit` (of the file) and `shown` (the unit that a field usually shows),
/// `absent` (what it means to leave the field out, where `default` cannot say it), `columns`, `units` and `shownUnits`
/// of numbers in a row, `names` (the lists of the project whose things the text names; `pieces`: or a piece of one,
/// "slope.2"; `quantity`: as NAME.displacement.z), `sharesNames` (lists whose things have no name in common),
/// `named` (words that stand for numbers),
/// `identifies` (the name of the thing itself), `variant` (what the choice of `oneOf` is about), `presets` (named sets
/// of values), `sets` (what becomes the default of other fields by the choice in this one) and `file` (the text is a
/// path to such files). `examples` are what a new thing begins with.
namespace talus::schema {

using Json = nlohmann::ordered_json;
using Place = Json::json_pointer;

const Json& root();
/// The rule with what it refers to filled in; its own words go before those. `of` then is the name of the definition
/// that it refers to: "at" of a place, "block_name" of the name of a block.
Json resolved(const Json& rule);
/// The rule of what stands, or may stand, at a place of a project. Throws std::out_of_range where nothing may.
Json ruleOf(const Place& place);
/// The title, description or another word of a rule in the user's language; empty where it has none.
QString words(const Json& rule, const char* key);
/// A word that the file has, one of some that may stand there, in the user's language.
QString choiceWords(const std::string& word);
/// A title within a sentence: with a small letter in languages that have it so, unless a person's name begins it.
QString withinSentence(const QString& title);
/// What the core says in keys of the file, with the titles of the forms in their place: "shorten time_step" is shorten
/// 'Time step'. Keys of one word stay: they are words, and may be anybody's name.
QString inWordsOfForms(QString sentence);

/// The rule of a member of what `rule` describes, resolved; null where there is none.
Json memberRule(const Json& rule, const std::string& key);

/// Gives the rule of a member the default that a choice in the object sets for it (`sets`).
void setDefault(Json& memberRule, const std::string& key, const Json& objectRule, const Json& object);

enum class Kind {
  constant,
  choice,  ///< one of some words
  boolean,
  number,
  namedNumber,  ///< a number, or the name of one
  text,
  numbers,  ///< so many in a row: a vector
  texts,    ///< so many in a row: a pair of names
  table,    ///< rows of numbers
  list,     ///< of anything else
  named,    ///< things by name
  object    ///< fields with keys of their own
};
Kind kindOf(const Json& rule);

/// The keys of which an object has exactly one.
std::vector<std::string> variants(const Json& rule);
/// May be left out of the object that holds it.
bool isOptional(const Json& objectRule, const std::string& key);
/// Keys that must be there, or go, together with `key`.
std::vector<std::string> neededBy(const Json& objectRule, const std::string& key);
std::vector<std::string> thatNeed(const Json& objectRule, const std::string& key);

}  // namespace talus::schema
