#include "results/struggle.hpp"

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

std::string what_happened(const Struggle& struggle) {
  switch (struggle.cause) {
    case StruggleCause::many_iterations:
      return "the open-close iteration settled slowly";
    case StruggleCause::found_late:
      return "blocks turned into each other where no contact could be foreseen";
    case StruggleCause::not_settled:
      return "the open-close iteration did not settle";
    case StruggleCause::inverted:
      break;
  }
  return "a tetrahedron of " + contact_text(struggle) + " turned inside out";
}

std::string where(const Struggle& struggle) {
  const std::string contact = contact_text(struggle);
  if (contact.empty()) return "";
  if (struggle.cause == StruggleCause::inverted) return " at " + position_text(struggle);
  std::string text = struggle.blocks[1].empty() ? ": " : ": contact ";
  text += contact + " at " + position_text(struggle);
  return struggle.joint.empty() ? text : text + ", joint " + struggle.joint;
}

bool harder(const Struggle& a, const Struggle& b) {
  return std::tuple(a.ended_run, a.cause, a.most_iterations) > std::tuple(b.ended_run, b.cause, b.most_iterations);
}

}  // namespace

std::string contact_text(const Struggle& struggle) {
  const auto& [first, second] = struggle.blocks;
  if (first.empty()) return "";
  return second.empty() ? "block " + first : first + " – " + second;
}

std::string position_text(const Struggle& struggle) {
  const Vec3& p = struggle.position;
  return "(" + short_number(p.x()) + ", " + short_number(p.y()) + ", " + short_number(p.z()) + ") m";
}

std::string failure_text(const Struggle& struggle) {
  return what_happened(struggle) + " at t = " + short_number(struggle.time) + " s" + where(struggle) + "; " +
         struggle.advice;
}

void StruggleList::add(const Struggle& struggle) {
  const auto same = std::find_if(places_.begin(), places_.end(),
                                 [&](const Struggle& place) { return place.blocks == struggle.blocks; });
  if (same == places_.end()) {
    places_.push_back(struggle);
    return;
  }
  const Struggle before = *same;
  if (harder(struggle, before)) *same = struggle;
  same->iterations = before.iterations + struggle.iterations;
  same->cuts = before.cuts + struggle.cuts;
}

std::vector<Struggle> StruggleList::hardest(std::size_t most) const {
  std::vector<Struggle> list = places_;
  std::stable_sort(list.begin(), list.end(), [](const Struggle& a, const Struggle& b) {
    return std::tuple(a.ended_run, a.cuts, a.iterations) > std::tuple(b.ended_run, b.cuts, b.iterations);
  });
  list.resize(std::min(list.size(), most));
  return list;
}

}  // namespace talus
