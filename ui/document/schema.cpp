#include "document/schema.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <map>
#include <stdexcept>

#include "io/project_schema.hpp"

namespace talus::schema {

const Json& root() {
  static const Json json = Json::parse(project_schema_text());
  return json;
}

Json resolved(const Json& rule) {
  if (!rule.contains("$ref")) return rule;
  const Place definition(rule.at("$ref").get<std::string>().substr(1));
  Json whole = resolved(root().at(definition));
  whole["of"] = definition.back();
  for (const auto& [key, value] : rule.items())
    if (key != "$ref") whole[key] = value;
  return whole;
}

QString words(const Json& rule, const char* key) {
  const std::string own = rule.value(key, std::string());
  return own.empty() ? QString() : QCoreApplication::translate("schema", own.c_str());
}

QString choiceWords(const std::string& word) {
  const QString words = QCoreApplication::translate("choices", word.c_str());
  return words.toStdString() == word ? QString(words).replace(u'_', u' ') : words;
}

QString withinSentence(const QString& title) {
  // Translators of languages that keep capital letters, as German does, give another word for this one.
  const char* const rule = QT_TRANSLATE_NOOP("grammar", "lower case");
  const bool lower = QCoreApplication::translate("grammar", rule) == QLatin1String(rule);
  const bool person = title.startsWith(QStringLiteral("Young")) || title.startsWith(QStringLiteral("Poisson"));
  return lower && !person ? title.left(1).toLower() + title.mid(1) : title;
}

namespace {

/// The titles of all fields whose key is of several words.
void collectTitles(const Json& rule, std::map<QString, QString>& titles) {
  if (rule.contains("properties") && rule.at("properties").is_object())
    for (const auto& [key, member] : rule.at("properties").items())
      if (key.find('_') != std::string::npos)
        if (const QString title = words(resolved(member), "title"); !title.isEmpty())
          titles[QString::fromStdString(key)] = title;
  for (const auto& inner : rule)
    if (inner.is_structured()) collectTitles(inner, titles);
}

}  // namespace

QString inWordsOfForms(QString sentence) {
  static const QRegularExpression keys(QStringLiteral("(['\"]?)\\b([a-z]+(?:_[a-z]+)+)\\b\\1"));
  std::map<QString, QString> titles;
  if (sentence.contains(u'_')) collectTitles(root(), titles);
  for (qsizetype from = 0; !titles.empty();) {
    const QRegularExpressionMatch found = keys.match(sentence, from);
    if (!found.hasMatch()) break;
    const auto title = titles.find(found.captured(2));
    const bool isQuoted = found.capturedLength(1) > 0;
    const QString words = title == titles.end() ? found.captured(0)
                          : isQuoted            ? u'\'' + title->second + u'\''
                                                : withinSentence(title->second);
    sentence.replace(found.capturedStart(), found.capturedLength(), words);
    from = found.capturedStart() + words.size();
  }
  return sentence;
}

Json memberRule(const Json& rule, const std::string& key) {
  if (rule.contains("properties") && rule.at("properties").contains(key))
    return resolved(rule.at("properties").at(key));
  if (rule.contains("additionalProperties") && rule.at("additionalProperties").is_object())
    return resolved(rule.at("additionalProperties"));
  if (rule.contains("items")) {
    Json item = resolved(rule.at("items"));
    for (const char* word : {"unit", "shown"})  // of a vector: of each of its numbers
      if (rule.contains(word) && item.value("type", Json()) != "array") item[word] = rule.at(word);
    return item;
  }
  return {};
}

void setDefault(Json& member, const std::string& key, const Json& objectRule, const Json& object) {
  const Json properties = objectRule.value("properties", Json::object());
  for (const auto& [choice, rule] : properties.items()) {
    if (!rule.contains("sets") || !object.contains(choice)) continue;
    const Json set = rule.at("sets").value(object.at(choice).get<std::string>(), Json::object());
    if (set.contains(key)) member["default"] = set.at(key);
  }
}

Json ruleOf(const Place& place) {
  if (place.empty()) return root();
  const Place above = place.parent_pointer();
  Json rule = above.empty() ? memberRule(root(), place.back()) : memberRule(ruleOf(above), place.back());  // no copy
  if (rule.is_null()) throw std::out_of_range("a project says nothing at " + place.to_string());
  return rule;
}

Kind kindOf(const Json& rule) {
  if (rule.contains("const")) return Kind::constant;
  if (rule.contains("enum")) return Kind::choice;
  if (rule.contains("named")) return Kind::namedNumber;
  const std::string type = rule.at("type").is_string() ? rule.at("type").get<std::string>() : "number";  // or null
  if (type == "boolean") return Kind::boolean;
  if (type == "number" || type == "integer") return Kind::number;
  if (type == "string") return Kind::text;
  if (type == "object") return rule.contains("properties") ? Kind::object : Kind::named;
  const Json item = resolved(rule.at("items"));
  const Kind each = kindOf(item);
  const bool ofOneLength = rule.contains("maxItems") && rule.value("minItems", Json()) == rule.at("maxItems");
  if (ofOneLength) return each == Kind::number ? Kind::numbers : Kind::texts;
  const bool numbersInRows =
      item.value("type", Json()) == "array" && kindOf(resolved(item.at("items"))) == Kind::number;
  return numbersInRows ? Kind::table : Kind::list;
}

std::vector<std::string> variants(const Json& rule) {
  std::vector<std::string> keys;
  for (const auto& choice : rule.value("oneOf", Json::array())) keys.push_back(choice.at("required").at(0));
  return keys;
}

bool isOptional(const Json& objectRule, const std::string& key) {
  const auto choices = variants(objectRule);
  const Json required = objectRule.value("required", Json::array());
  return std::find(required.begin(), required.end(), key) == required.end() &&
         std::find(choices.begin(), choices.end(), key) == choices.end();
}

std::vector<std::string> neededBy(const Json& objectRule, const std::string& key) {
  const Json partners = objectRule.value("dependencies", Json::object());
  return partners.contains(key) ? partners.at(key).get<std::vector<std::string>>() : std::vector<std::string>{};
}

std::vector<std::string> thatNeed(const Json& objectRule, const std::string& key) {
  std::vector<std::string> keys;
  const Json dependencies = objectRule.value("dependencies", Json::object());
  for (const auto& [other, partners] : dependencies.items())
    if (std::find(partners.begin(), partners.end(), key) != partners.end()) keys.push_back(other);
  return keys;
}

}  // namespace talus::schema
