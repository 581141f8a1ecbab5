#include "geometry/mesher/step_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace talus {
namespace {

/// "#7 = CARTESIAN_POINT('',(1.,2.))": what stands after the sign of equality, without strings and comments, and the
/// line in which it begins.
struct Statement {
  std::string text;
  int line = 0;
};

/// The number that begins there, and nothing where there is none.
template <class Number>
std::optional<Number> number_at(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  return number;
}

std::vector<long long> references_in(std::string_view text) {
  std::vector<long long> references;
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1))
    if (const auto number = number_at<long long>(text.substr(at + 1))) references.push_back(*number);
  return references;
}

/// The statements of a file by their numbers.
class Statements {
 public:
  explicit Statements(std::string_view text) {
    Statement read;
    int line = 1;
    for (std::size_t at = 0; at < text.size(); ++at) {
      const std::size_t end = end_of_what_is_not_read(text, at);
      if (end > at) {
        line += static_cast<int>(std::count(text.begin() + at, text.begin() + end, '\n'));
        at = end - 1;
      } else if (text[at] == ';') {
        keep(std::move(read));
        read = {};
      } else if (text[at] > ' ') {
        if (read.text.empty()) read.line = line;
        read.text += text[at];
      } else if (text[at] == '\n') {
        ++line;
      }
    }
  }

  const Statement* find(long long number) const {
    const auto found = by_number_.find(number);
    return found == by_number_.end() ? nullptr : &found->second;
  }

  auto begin() const { return by_number_.begin(); }
  auto end() const { return by_number_.end(); }

 private:
  /// Behind a string or a comment that begins there; otherwise where it is.
  static std::size_t end_of_what_is_not_read(std::string_view text, std::size_t at) {
    std::size_t end = at;
    if (text[at] == '\'')
      end = text.find('\'', at + 1) + 1;
    else if (text.substr(at, 2) == "/*")
      end = text.find("*/", at + 2) + 2;
    return end < at ? text.size() : end;
  }

  void keep(Statement statement) {
    const std::size_t equals = statement.text.find('=');
    if (equals == std::string::npos || statement.text[0] != '#') return;
    const auto number = number_at<long long>(std::string_view(statement.text).substr(1));
    statement.text.erase(0, equals + 1);
    if (number) by_number_.emplace(*number, std::move(statement));
  }

  std::unordered_map<long long, Statement> by_number_;
};

/// Its first parameter is an angle.
bool is_round(std::string_view surface) {
  constexpr std::array kinds = {"CYLINDRICAL_SURFACE(", "CONICAL_SURFACE(", "SPHERICAL_SURFACE(", "TOROIDAL_SURFACE(",
                                "SURFACE_OF_REVOLUTION("};
  return std::any_of(kinds.begin(), kinds.end(), [&](const char* kind) { return surface.starts_with(kind); });
}

/// The first coordinate of a point that has two.
std::optional<double> angle_of(std::string_view point) {
  if (!point.starts_with("CARTESIAN_POINT(") || std::count(point.begin(), point.end(), ',') != 2) return std::nullopt;
  std::string_view number = point.substr(point.rfind('(') + 1);
  if (number.starts_with('+')) number.remove_prefix(1);
  return number_at<double>(number);
}

[[noreturn]] void refuse(const MesherSolid& solid, const Statement& statement, const std::string& damage) {
  throw InputError(solid.file_as_written + ": line " + std::to_string(statement.line), "is damaged: " + damage,
                   "export the solid again as STEP");
}

/// Shells and all that they are made of, down to points.
void refuse_circles(const MesherSolid& solid, const Statements& statements) {
  enum class Visit { open, done };
  struct Entered {
    long long number;
    const Statement* statement;
    std::vector<long long> named;
  };
  std::unordered_map<long long, Visit> visits;
  std::vector<Entered> path;
  const auto enter = [&](long long number, const Statement* statement) {
    if (statement == nullptr || !visits.emplace(number, Visit::open).second) return;
    path.push_back({number, statement, references_in(statement->text)});
  };
  for (const auto& [first, shell] : statements) {
    if (!shell.text.starts_with("CLOSED_SHELL(") && !shell.text.starts_with("OPEN_SHELL(")) continue;
    enter(first, &shell);
    while (!path.empty()) {
      std::vector<long long>& named = path.back().named;
      if (named.empty()) {
        visits[path.back().number] = Visit::done;
        path.pop_back();
        continue;
      }
      const long long next = named.back();
      named.pop_back();
      if (const auto seen = visits.find(next); seen != visits.end() && seen->second == Visit::open)
        refuse(solid, *path.back().statement, "what stands there is part of itself");
      enter(next, statements.find(next));
    }
  }
}

/// Where edges run on faces around an axis, the curves that say so.
void refuse_far_angles(const MesherSolid& solid, const Statements& statements) {
  constexpr double farthest = 1e6;
  std::vector<long long> ahead;
  for (const auto& [number, statement] : statements) {
    if (!statement.text.starts_with("PCURVE(")) continue;
    const std::vector<long long> named = references_in(statement.text);
    const Statement* surface = named.size() == 2 ? statements.find(named[0]) : nullptr;
    if (surface != nullptr && is_round(surface->text)) ahead.push_back(named[1]);
  }
  std::unordered_set<long long> seen;
  while (!ahead.empty()) {
    const long long number = ahead.back();
    ahead.pop_back();
    const Statement* statement = statements.find(number);
    if (statement == nullptr || !seen.insert(number).second) continue;
    const auto angle = angle_of(statement->text);
    if (angle && !(std::abs(*angle) <= farthest))
      refuse(solid, *statement, "an edge of a round face lies at an angle beyond a million");
    for (const long long named : references_in(statement->text)) ahead.push_back(named);
  }
}

}  // namespace

void check_step_text(const MesherSolid& solid, std::string_view text) {
  const Statements statements(text);
  refuse_circles(solid, statements);
  refuse_far_angles(solid, statements);
}

}  // namespace talus
