#include "results/convergence_trouble.hpp"

#include <algorithm>
#include <cstdio>
#include <tuple>

namespace talus {

namespace {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string what_happened(const ConvergenceTrouble& trouble) {
  switch (trouble.cause) {
    case TroubleCause::many_iterations:
      return "the open-close iteration converged slowly";
    case TroubleCause::missed_contact:
      return "blocks turned into each other where no contact could be foreseen";
    case TroubleCause::not_converged:
      return "the open-close iteration did not converge";
    case TroubleCause::interpenetrating:
      return "blocks lie " + short_number(trouble.relative_penetration) + " of their mesh size in each other";
    case TroubleCause::inverted:
      break;
  }
  return "a tetrahedron of " + contact_text(trouble) + " turned inside out";
}

std::string where(const ConvergenceTrouble& trouble) {
  const std::string contact = contact_text(trouble);
  if (contact.empty()) return "";
  if (trouble.cause == TroubleCause::inverted) return " at " + position_text(trouble);
  std::string text = trouble.blocks[1].empty() ? ": " : ": contact ";
  text += contact + " at " + position_text(trouble);
  return trouble.joint.empty() ? text : text + ", joint " + trouble.joint;
}

bool harder(const ConvergenceTrouble& a, const ConvergenceTrouble& b) {
  return std::tuple(a.ended_run, a.cause, a.most_iterations) > std::tuple(b.ended_run, b.cause, b.most_iterations);
}

}  // namespace

std::string contact_text(const ConvergenceTrouble& trouble) {
  const auto& [first, second] = trouble.blocks;
  if (first.empty()) return "";
  return second.empty() ? "block " + first : first + " – " + second;
}

std::string position_text(const ConvergenceTrouble& trouble) {
  const Vec3& p = trouble.position;
  return "(" + short_number(p.x()) + ", " + short_number(p.y()) + ", " + short_number(p.z()) + ") m";
}

std::string failure_text(const ConvergenceTrouble& trouble) {
  return what_happened(trouble) + " at t = " + short_number(trouble.time) + " s" + where(trouble) + "; " +
         trouble.advice;
}

void TroubleList::add(const ConvergenceTrouble& trouble) {
  const auto same = std::find_if(places_.begin(), places_.end(),
                                 [&](const ConvergenceTrouble& place) { return place.blocks == trouble.blocks; });
  if (same == places_.end()) {
    places_.push_back(trouble);
    return;
  }
  const ConvergenceTrouble before = *same;
  if (harder(trouble, before)) *same = trouble;
  same->iterations = before.iterations + trouble.iterations;
  same->cuts = before.cuts + trouble.cuts;
}

std::vector<ConvergenceTrouble> TroubleList::hardest(std::size_t most) const {
  std::vector<ConvergenceTrouble> list = places_;
  std::stable_sort(list.begin(), list.end(), [](const ConvergenceTrouble& a, const ConvergenceTrouble& b) {
    return std::tuple(a.ended_run, a.cuts, a.iterations) > std::tuple(b.ended_run, b.cuts, b.iterations);
  });
  list.resize(std::min(list.size(), most));
  return list;
}

}  // namespace talus
