#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/project.hpp"

namespace talus {

/// A number that a template asks for.
struct TemplateNumber {
  std::string key;      ///< "face_angle"; the command line writes --face-angle
  std::string name;     ///< "Face angle"
  std::string meaning;  ///< in half a sentence
  std::string unit;     ///< "m", "°", "kPa"; empty for a count
  double least, most, preset;
  bool whole = false;  ///< a count
};

/// Numbers by their keys, in the units of their template.
using TemplateValues = std::map<std::string, double>;

/// A kind of slope or structure that a few numbers describe. What it makes of any numbers within their ranges is a
/// project that can be cut, meshed and run.
struct ProjectTemplate {
  std::string key;          ///< "bench-slope"
  std::string name;         ///< "Bench slope"
  std::string description;  ///< one or two sentences: what it is, and what decides its outcome
  std::vector<TemplateNumber> numbers;
  Project (*make)(const TemplateValues& values);  ///< of checked numbers, all of them
};

}  // namespace talus
