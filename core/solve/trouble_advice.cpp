#include "solve/trouble_advice.hpp"

#include <cstdio>

namespace talus {

namespace {

/// Of the mesh size: blocks that lie deeper in each other change which features touch, and how, within a step.
constexpr double deep = 1e-2;

std::string shorter_step(double length) {
  char text[80];
  std::snprintf(text, sizeof text, "a shorter time_step usually helps: %.2g s is too long there", length);
  return text;
}

std::string merge_chip(const Chip& chip) {
  char text[120];
  std::snprintf(text, sizeof text, " is a chip beside what it touches: merge splinters of a thickness up to %.2g m",
                1.1 * chip.thickness);
  return chip.name + text;
}

}  // namespace

std::string advice_for(const ConvergenceTrouble& trouble, double length, const SolverSettings& settings,
                       const std::optional<Chip>& chip) {
  if (trouble.cause == TroubleCause::inverted)
    return "a finer mesh, a shorter time_step or stiffer rock keeps its shape";
  if (trouble.cause == TroubleCause::missed_contact) return shorter_step(length);
  if (chip) return merge_chip(*chip);
  if (trouble.relative_penetration > deep)
    return settings.penetration_tolerance ? "blocks lie deep in each other: raise contact_stiffness"
                                          : "blocks lie deep in each other: set penetration_tolerance";
  const int usual = SolverSettings{}.open_close_limit;
  if (trouble.cause == TroubleCause::not_converged && settings.open_close_limit < usual)
    return "raise open_close_limit: " + std::to_string(settings.open_close_limit) + " iterations were allowed, " +
           std::to_string(usual) + " are usual";
  return shorter_step(length);
}

}  // namespace talus
