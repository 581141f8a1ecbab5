#include "io/schema_check.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "base/error.hpp"
#include "io/project_schema.hpp"
#include "model/number_text.hpp"
#include "model/place.hpp"
#include "model/suggestion.hpp"

namespace talus {
namespace {

using Json = nlohmann::json;

const Json& schema_json() {
  static const Json json = Json::parse(project_schema_text());
  return json;
}

/// The schema of a project that is still being set up: of itself it may lack everything but its version.
const Json& unfinished_schema_json() {
  static const Json json = [] {
    Json relaxed = schema_json();
    relaxed["required"] = {"talus"};
    for (auto& property : relaxed["properties"]) property.erase("minItems");
    return relaxed;
  }();
  return json;
}

std::unique_ptr<valijson::Schema> compiled(const Json& schema) {
  auto made = std::make_unique<valijson::Schema>();
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), *made);
  return made;
}

const Json& view_schema_json() {
  static const Json json = Json::parse(view_schema_text());
  return json;
}

/// A schema, and what the validator makes of it.
struct Schema {
  const Json& json;
  std::unique_ptr<valijson::Schema> made = compiled(json);
};

/// The smaller comes first among several faults of one text.
enum class Weight { unknown_key, other };

struct Fault {
  Weight weight;
  Place place;
  std::string problem, remedy;
};

/// The schema of views refers to nothing.
const Json& resolved(const Json& rule) {
  if (!rule.contains("$ref")) return rule;
  return schema_json().at(Json::json_pointer(rule.at("$ref").get<std::string>().substr(1)));
}

std::string remedy_from(const Json& rule) {
  const auto& described = rule.contains("description") ? rule : resolved(rule);
  return "expected: " + described.value("description", std::string("what the manual says"));
}

std::string shown(const Json& value) {
  if (value.is_number_float()) return number_text(value.get<double>());
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  constexpr std::size_t most = 40;
  const std::string text = value.dump();
  return text.size() <= most ? text : "a long text";
}

std::string type_words(const Json& type) {
  if (type.is_array()) {
    std::string words;
    for (const auto& one : type) words += (words.empty() ? "" : " or ") + type_words(one);
    return words;
  }
  const auto name = type.get<std::string>();
  if (name == "number") return "a number";
  if (name == "integer") return "a whole number";
  if (name == "string") return "a text in quotes";
  if (name == "boolean") return "true or false";
  if (name == "object") return "an object { … }";
  if (name == "array") return "a list [ … ]";
  return name;
}

bool has_type(const Json& value, const Json& type) {
  if (type.is_array())
    return std::any_of(type.begin(), type.end(), [&](const Json& one) { return has_type(value, one); });
  const auto name = type.get<std::string>();
  if (name == "number") return value.is_number();
  if (name == "integer") return value.is_number_integer();
  if (name == "string") return value.is_string();
  if (name == "boolean") return value.is_boolean();
  if (name == "object") return value.is_object();
  if (name == "array") return value.is_array();
  return value.is_null();
}

std::vector<std::string> known_keys(const Json& rule) {
  std::vector<std::string> keys;
  for (const auto& [key, property] : rule.at("properties").items()) keys.push_back(key);
  return keys;
}

std::optional<Fault> unknown_key(const Json& value, const Json& rule, const Place& place) {
  if (!value.is_object() || rule.value("additionalProperties", Json()) != Json(false)) return std::nullopt;
  for (const auto& [key, ignored] : value.items()) {
    if (rule.at("properties").contains(key)) continue;
    return Fault{Weight::unknown_key, place / key, "the key '" + key + "' is not known here",
                 suggest_name(key, known_keys(rule))};
  }
  return std::nullopt;
}

std::optional<Fault> missing_key(const Json& value, const Json& rule, const Place& place) {
  if (!value.is_object()) return std::nullopt;
  const Json required = rule.value("required", Json::array());
  for (const auto& key : required) {
    const auto name = key.get<std::string>();
    if (value.contains(name)) continue;
    return Fault{Weight::other, place, "'" + name + "' is missing",
                 "add it, " + remedy_from(rule.at("properties").at(name))};
  }
  const Json dependencies = rule.value("dependencies", Json::object());
  for (const auto& [key, partners] : dependencies.items()) {
    for (const auto& partner : partners) {
      const auto name = partner.get<std::string>();
      if (!value.contains(key) || value.contains(name)) continue;
      return Fault{Weight::other, place, "'" + key + "' is given without '" + name + "'",
                   "add it, " + remedy_from(rule.at("properties").at(name))};
    }
  }
  return std::nullopt;
}

/// The schema uses `named` for numbers that have names, and says them again as a pattern for its validator.
std::optional<Fault> unknown_name(const Json& value, const Json& rule, const Place& place) {
  if (!value.is_string() || !rule.contains("named")) return std::nullopt;
  const auto names = rule.at("named").get<std::vector<std::string>>();
  const auto name = value.get<std::string>();
  if (std::find(names.begin(), names.end(), name) != names.end()) return std::nullopt;
  return Fault{Weight::other, place, shown(value) + " is not known here", suggest_name(name, names)};
}

/// The schema uses oneOf for keys of which exactly one is given.
std::optional<Fault> not_one_of(const Json& value, const Json& rule, const Place& place) {
  if (!value.is_object() || !rule.contains("oneOf")) return std::nullopt;
  std::string all, given;
  int count = 0;
  for (const auto& choice : rule.at("oneOf")) {
    const std::string name = "'" + choice.at("required").at(0).get<std::string>() + "'";
    all += (all.empty() ? "" : ", ") + name;
    if (!value.contains(choice.at("required").at(0).get<std::string>())) continue;
    given += (given.empty() ? "" : " and ") + name;
    ++count;
  }
  if (count == 1) return std::nullopt;
  return Fault{Weight::other, place, count == 0 ? "none of " + all + " is given" : given + " are given together",
               "give exactly one of " + all};
}

std::optional<Fault> out_of_range(const Json& value, const Json& rule, const Place& place) {
  if (!value.is_number()) return std::nullopt;
  const auto number = value.get<double>();
  const auto breaks = [&](const char* keyword, auto holds, const std::string& words) -> std::optional<Fault> {
    if (!rule.contains(keyword) || holds(number, rule.at(keyword).get<double>())) return std::nullopt;
    return Fault{Weight::other, place,
                 "must be " + words + number_text(rule.at(keyword).get<double>()) + ", is " + shown(value),
                 remedy_from(rule)};
  };
  if (auto fault = breaks("minimum", std::greater_equal<>(), "at least ")) return fault;
  if (auto fault = breaks("exclusiveMinimum", std::greater<>(), "greater than ")) return fault;
  if (auto fault = breaks("maximum", std::less_equal<>(), "at most ")) return fault;
  return breaks("exclusiveMaximum", std::less<>(), "below ");
}

std::optional<Fault> wrong_length(const Json& value, const Json& rule, const Place& place) {
  const bool text = value.is_string();
  if (!text && !value.is_array()) return std::nullopt;
  const std::size_t size = text ? value.get_ref<const std::string&>().size() : value.size();
  const std::size_t least = rule.value(text ? "minLength" : "minItems", std::size_t{0});
  const std::size_t most = rule.value("maxItems", size);
  if (size >= least && size <= most) return std::nullopt;
  if (text) return Fault{Weight::other, place, "is empty", remedy_from(rule)};
  const std::string wanted = least == most  ? std::to_string(least)
                             : size < least ? "at least " + std::to_string(least)
                                            : "at most " + std::to_string(most);
  return Fault{Weight::other, place, "must have " + wanted + " entries, has " + std::to_string(size),
               remedy_from(rule)};
}

/// What is wrong with `value` itself (not with what it holds), by the schema's rule for it.
std::optional<Fault> explain(const Json& value, const Json& rule, const Place& place) {
  if (rule.contains("type") && !has_type(value, rule.at("type"))) {
    return Fault{Weight::other, place, "must be " + type_words(rule.at("type")) + ", is " + shown(value),
                 remedy_from(rule)};
  }
  if (rule.contains("enum")) {
    const auto& choices = rule.at("enum");
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return std::nullopt;
    const auto words = choices.get<std::vector<std::string>>();
    return Fault{Weight::other, place, shown(value) + " is not known here",
                 suggest_name(value.is_string() ? value.get<std::string>() : std::string(), words)};
  }
  if (auto fault = unknown_key(value, rule, place)) return fault;
  if (auto fault = missing_key(value, rule, place)) return fault;
  if (auto fault = not_one_of(value, rule, place)) return fault;
  if (auto fault = unknown_name(value, rule, place)) return fault;
  if (auto fault = out_of_range(value, rule, place)) return fault;
  return wrong_length(value, rule, place);
}

/// Follows the validator's path ("<root>", "[solids]", "[0]", …) through text and schema at once.
std::optional<Fault> explain_at(const std::vector<std::string>& path, const Json& root, const Json& schema) {
  const Json* value = &root;
  const Json* rule = &schema;
  Place place;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const std::string key = path[i].substr(1, path[i].size() - 2);
    if (value->is_array()) {
      const std::size_t index = std::stoul(key);
      place = place / index;
      value = &value->at(index);
      rule = &resolved(rule->at("items"));
    } else {
      place = place / key;
      value = &value->at(key);
      const auto properties = rule->find("properties");
      const bool listed = properties != rule->end() && properties->contains(key);
      rule = &resolved(listed ? properties->at(key) : rule->at("additionalProperties"));
    }
  }
  return explain(*value, *rule, place);
}

/// The validator counts whole numbers in 63 bits; a density of 2^63 is as good a number as any.
void large_numbers_as_floats(Json& value) {
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max())
    value = value.get<double>();
  else if (value.is_structured())
    for (Json& part : value) large_numbers_as_floats(part);
}

/// What the first fault is sought among, of each key of the project: a list of 100 000 may be wrong in every entry.
constexpr int most_faults_of_a_key = 100;

void check(const JsonText& json, const Schema& schema) {
  Json value = json.value;  // the validator's adapter knows the library's own object type alone
  large_numbers_as_floats(value);
  valijson::ValidationResults results;
  valijson::Validator validator;
  if (validator.validate(*schema.made, valijson::adapters::NlohmannJsonAdapter(value), &results)) return;

  using Rank = std::pair<Weight, std::size_t>;
  std::optional<std::pair<Rank, Fault>> first;
  std::map<std::string, int> faults_of_key;
  for (const auto& error : results) {
    int& faults = faults_of_key[error.context.size() > 1 ? error.context[1] : std::string()];
    if (faults == most_faults_of_a_key) continue;
    const auto fault = explain_at(error.context, value, schema.json);
    if (!fault) continue;  // the fault lies in something that this value holds
    ++faults;
    const Rank rank{fault->weight, offset_in_text(json, fault->place.pointer())};
    if (!first || rank < first->first) first = {rank, *fault};
  }
  if (!first) throw InputError(place_in_text(json, "/"), "does not fit the schema", "compare it with the manual");
  throw InputError(place_in_text(json, first->second.place.text()), first->second.problem, first->second.remedy);
}

}  // namespace

void check_against_schema(const JsonText& json, bool unfinished) {
  static const Schema finished_schema{schema_json()}, unfinished_schema{unfinished_schema_json()};
  check(json, unfinished ? unfinished_schema : finished_schema);
}

void check_view_against_schema(const JsonText& json) {
  static const Schema schema{view_schema_json()};
  check(json, schema);
}

}  // namespace talus
