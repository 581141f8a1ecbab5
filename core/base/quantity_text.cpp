#include "base/quantity_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"

namespace talus {
namespace {

using Powers = std::array<int, 4>;  // of m, kg, s, rad

/// `factor` times ten to the power of `tens`, in SI units. Apart, so that 12 mm is 0.012 m to the last digit.
struct Unit {
  Powers powers{};
  double factor = 1;
  int tens = 0;
};

struct Symbol {
  std::string_view name;
  Unit unit;
  bool takes_prefix;
};

const Symbol symbols[] = {
    {"m", {{1, 0, 0, 0}}, true},
    {"g", {{0, 1, 0, 0}, 1, -3}, true},
    {"t", {{0, 1, 0, 0}, 1, 3}, true},
    {"s", {{0, 0, 1, 0}}, true},
    {"min", {{0, 0, 1, 0}, 60}, false},
    {"h", {{0, 0, 1, 0}, 3600}, false},
    {"d", {{0, 0, 1, 0}, 86400}, false},
    {"rad", {{0, 0, 0, 1}}, true},
    {"°", {{0, 0, 0, 1}, std::numbers::pi / 180}, false},
    {"deg", {{0, 0, 0, 1}, std::numbers::pi / 180}, false},
    {"N", {{1, 1, -2, 0}}, true},
    {"Pa", {{-1, 1, -2, 0}}, true},
    {"bar", {{-1, 1, -2, 0}, 1, 5}, true},
    {"J", {{2, 1, -2, 0}}, true},
    {"Hz", {{0, 0, -1, 0}}, true},
    {"in", {{1, 0, 0, 0}, 254, -4}, false},
    {"ft", {{1, 0, 0, 0}, 3048, -4}, false},
    {"lb", {{0, 1, 0, 0}, 45359237, -8}, false},
    {"lbf", {{1, 1, -2, 0}, 4.4482216152605}, false},
    {"psi", {{-1, 1, -2, 0}, 6894.757293168361}, false},
    {"pcf", {{-3, 1, 0, 0}, 16.018463373960142}, false},
    {"%", {{}, 1, -2}, false},
    {"1", {{}}, false},
};

constexpr std::pair<std::string_view, int> prefixes[] = {{"k", 3},  {"M", 6},  {"G", 9},  {"T", 12}, {"c", -2},
                                                         {"d", -1}, {"m", -3}, {"µ", -6}, {"μ", -6}, {"n", -9}};

struct Measure {
  Powers powers;
  const char *name, *units;
};

constexpr Measure measures[] = {
    {{0, 0, 0, 0}, "a pure number", "no unit, or %"},
    {{1, 0, 0, 0}, "a length", "m, cm, mm, km, ft or in"},
    {{-1, 0, 0, 0}, "an area per volume", "m²/m³ or 1/m"},
    {{2, 0, 0, 0}, "an area", "m²"},
    {{3, 0, 0, 0}, "a volume", "m³"},
    {{0, 1, 0, 0}, "a mass", "kg or t"},
    {{0, 0, 1, 0}, "a time", "s, ms, min, h or d"},
    {{0, 0, 0, 1}, "an angle", "° or rad"},
    {{0, 0, -1, 1}, "a speed of rotation", "rad/s or °/s"},
    {{0, 0, -1, 0}, "a rate", "1/s or Hz"},
    {{1, 0, -1, 0}, "a velocity", "m/s, mm/s or km/h"},
    {{1, 0, -2, 0}, "an acceleration", "m/s²"},
    {{-3, 1, 0, 0}, "a density", "kg/m³ or t/m³, or kN/m³ for the weight"},
    {{1, 1, -2, 0}, "a force", "N, kN or MN"},
    {{-1, 1, -2, 0}, "a stress", "Pa, kPa, MPa, GPa or psi"},
    {{-2, 1, -2, 0}, "a stress per length, or a weight per volume", "Pa/m, MPa/m, GPa/m or kN/m³"},
    {{2, 1, -2, 0}, "an energy", "J or kJ"},
};

constexpr Powers density{-3, 1, 0, 0}, weight_per_volume{-2, 1, -2, 0};

const Measure* measure_of(const Powers& powers) {
  const auto found = std::find_if(std::begin(measures), std::end(measures),
                                  [&](const Measure& measure) { return measure.powers == powers; });
  return found == std::end(measures) ? nullptr : found;
}

void replace_all(std::string& text, std::string_view what, std::string_view with) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

std::optional<Unit> symbol_unit(std::string_view name) {
  for (const auto& symbol : symbols)
    if (symbol.name == name) return symbol.unit;
  for (const auto& [prefix, tens] : prefixes) {
    if (!name.starts_with(prefix)) continue;
    for (const auto& symbol : symbols) {
      if (!symbol.takes_prefix || symbol.name != name.substr(prefix.size())) continue;
      Unit unit = symbol.unit;
      unit.tens += tens;
      return unit;
    }
  }
  return std::nullopt;
}

/// "m3", "s-2", "m": a symbol and its power.
std::optional<Unit> power_unit(std::string_view text) {
  std::size_t end = text.find_first_of("-0123456789");
  int power = 1;
  if (end == 0) end = std::string_view::npos;  // the 1 of 1/s
  if (end != std::string_view::npos) {
    const auto read = std::from_chars(text.data() + end, text.data() + text.size(), power);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || std::abs(power) > 9) return std::nullopt;
  }
  auto unit = symbol_unit(text.substr(0, end));
  if (!unit) return std::nullopt;
  for (int& each : unit->powers) each *= power;
  unit->factor = std::pow(unit->factor, power);
  unit->tens *= power;
  return unit;
}

std::optional<Unit> parse_unit(std::string text) {
  for (const auto& [written, plain] : {std::pair{"⁻", "-"},
                                       {"¹", "1"},
                                       {"²", "2"},
                                       {"³", "3"},
                                       {"⁴", "4"},
                                       {"^", ""},
                                       {"·", " "},
                                       {"*", " "},
                                       {"−", "-"},
                                       {"/", " / "}})
    replace_all(text, written, plain);
  Unit product;
  int sign = 1;
  for (std::size_t at = text.find_first_not_of(' '); at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = std::string_view(text).substr(at, end - at);
    at = std::min(text.find_first_not_of(' ', end), text.size());
    if (word == "/") {
      if (sign < 0 || at == text.size()) return std::nullopt;
      sign = -1;
      continue;
    }
    const auto unit = power_unit(word);
    if (!unit) return std::nullopt;
    for (std::size_t i = 0; i < product.powers.size(); ++i) product.powers[i] += sign * unit->powers[i];
    product.factor *= sign > 0 ? unit->factor : 1 / unit->factor;
    product.tens += sign * unit->tens;
    sign = 1;
  }
  if (sign < 0) return std::nullopt;
  return product;
}

Unit known_unit(const std::string& text) {
  if (const auto unit = parse_unit(text)) return *unit;
  throw InputError("the unit", "the unit '" + text + "' is not known here", "type one such as m, kPa, t/m³, ° or s");
}

/// Multiplies or divides by a power of ten, whichever rounds once.
double scaled(double value, int tens) {
  return tens >= 0 ? value * std::pow(10.0, tens) : value / std::pow(10.0, -tens);
}

/// A weight per volume as the density that it is of, or the other way.
Unit weighed(Unit unit, const Powers& wanted) {
  const bool to_density = wanted == density && unit.powers == weight_per_volume;
  const bool to_weight = wanted == weight_per_volume && unit.powers == density;
  if (to_density) unit.factor /= weight_gravity;
  if (to_weight) unit.factor *= weight_gravity;
  if (to_density || to_weight) unit.powers = wanted;
  return unit;
}

double converted(double value, const std::string& name, Unit from, const Unit& to) {
  from = weighed(from, to.powers);
  if (from.powers == to.powers) {
    const double ratio = from.factor == to.factor ? 1 : from.factor / to.factor;
    return scaled(value * ratio, from.tens - to.tens);
  }
  const Measure *given = measure_of(from.powers), *wanted = measure_of(to.powers);
  throw InputError("the unit",
                   "'" + name + "' is " + (given ? given->name : "something else") + ", and " +
                       (wanted ? wanted->name : "another quantity") + " is wanted here",
                   wanted ? std::string("type it in ") + wanted->units : "leave the unit away");
}

/// Takes the number off the front of `text`, which then begins with the unit.
double take_number(std::string& text) {
  for (const auto& [written, plain] :
       {std::pair{"\u2009", " "}, {"\u202f", " "}, {"\u00a0", " "}, {"−", "-"}, {",", "."}})
    replace_all(text, written, plain);
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto digits_from = [&](std::size_t at) {
    return static_cast<std::size_t>(
               std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), is_digit) - text.begin()) -
           at;
  };
  for (std::size_t i = 1; i < text.size(); ++i)  // 12 000, but not 0.5 1/s
    if (text[i] == ' ' && is_digit(text[i - 1]) && digits_from(i + 1) == 3) text.erase(i, 1);
  text.erase(0, text.find_first_not_of(" +"));
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || !std::isfinite(number))
    throw InputError("the number", "this is not a number", "type one such as 2.5, 1e6 or 50 kPa");
  text.erase(0, static_cast<std::size_t>(read.ptr - text.data()));
  return number;
}

}  // namespace

double read_quantity(const std::string& text, const std::string& kept, const std::string& shown) {
  std::string rest = text;
  const double number = take_number(rest);
  rest.erase(0, std::min(rest.find_first_not_of(' '), rest.size()));
  rest.erase(rest.find_last_not_of(' ') + 1);
  const std::string& name = rest.empty() ? shown : rest;
  if (name == kept) return number;
  return converted(number, name, known_unit(name), known_unit(kept));
}

double converted(double value, const std::string& from, const std::string& to) {
  return from == to ? value : converted(value, from, known_unit(from), known_unit(to));
}

}  // namespace talus
