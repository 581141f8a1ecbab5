#include "templates/templates.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "model/number_text.hpp"
#include "model/suggestion.hpp"
#include "templates/structures.hpp"

namespace talus {

const std::vector<ProjectTemplate>& project_templates() {
  static const std::vector<ProjectTemplate> all{bench_slope(), rock_wedge(), toppling_face(), rock_column(),
                                                tunnel_roof(), cavern(),     dry_stone_wall()};
  return all;
}

const ProjectTemplate& template_named(const std::string& key) {
  std::vector<std::string> keys;
  for (const ProjectTemplate& candidate : project_templates()) {
    if (candidate.key == key) return candidate;
    keys.push_back(candidate.key);
  }
  throw InputError("template", "there is none called '" + key + "'", suggest_name(key, keys));
}

std::string range_text(const TemplateNumber& number) {
  return number_text(number.least) + " to " + number_text(number.most) + (number.unit.empty() ? "" : " " + number.unit);
}

void check_number(const TemplateNumber& number, double value) {
  if (!(value >= number.least && value <= number.most)) {
    throw InputError(number.name, "must be " + range_text(number) + ", is " + number_text(value),
                     number.meaning + "; " + number_text(number.preset) + " is usual");
  }
  if (number.whole && value != std::round(value)) {
    throw InputError(number.name, "is a count, not " + number_text(value), "give a whole number");
  }
}

Project project_from(const ProjectTemplate& chosen, const TemplateValues& given) {
  TemplateValues values;
  std::vector<std::string> keys;
  for (const TemplateNumber& number : chosen.numbers) {
    values[number.key] = number.preset;
    keys.push_back(number.key);
  }
  for (const auto& [key, value] : given) {
    const auto number = std::find_if(chosen.numbers.begin(), chosen.numbers.end(),
                                     [&](const TemplateNumber& candidate) { return candidate.key == key; });
    if (number == chosen.numbers.end())
      throw InputError(chosen.name, "has no number '" + key + "'", suggest_name(key, keys));
    check_number(*number, value);
    values[key] = value;
  }
  return chosen.make(values);
}

}  // namespace talus
