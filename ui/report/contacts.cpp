#include <cmath>
#include <map>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "render/paint/numbers.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

/// What the contact points of a joint carry together.
struct Load {
  long open = 0, stick = 0, slip = 0;
  double normal = 0, shear = 0;  ///< N, sums of magnitudes
};

std::map<int, Load> loads_by_joint(const Frame& frame) {
  std::map<int, Load> loads;
  for (const ContactSample& contact : frame.contacts) {
    Load& load = loads[contact.joint];
    ++(contact.state == ContactState::open ? load.open : contact.state == ContactState::stick ? load.stick : load.slip);
    if (contact.state == ContactState::open) continue;
    load.normal += contact.normal_force;
    load.shear += contact.shear_force.norm();
  }
  return loads;
}

}  // namespace

Section contacts(const RunRecord& run) {
  Section section{"Contacts in the last frame", {}};
  if (run.last.contacts.empty()) {
    section.parts.emplace_back(Paragraph{"No block touches another one."});
    return section;
  }
  const std::map<int, Load> loads = loads_by_joint(run.last);
  double largest = 0;
  for (const auto& [joint, load] : loads) largest = std::max(largest, load.normal);
  const Prefixed force = prefixed("N", largest);
  Table table{"By joint",
              {"Joint", "Points", "Open", "Stick", "Slip", "Normal force (" + force.unit + ")",
               "Shear force (" + force.unit + ")", "Mobilised angle (°)"},
              "lrrrrrrr",
              {}};
  for (const auto& [joint, load] : loads) {
    const auto number = static_cast<std::size_t>(joint);
    const bool named = joint >= 0 && number < run.system().joint_names.size();
    table.rows.push_back({named ? run.system().joint_names[number] : "no joint",
                          count_text(load.open + load.stick + load.slip), count_text(load.open), count_text(load.stick),
                          count_text(load.slip), format_number(force.factor * load.normal, 3),
                          format_number(force.factor * load.shear, 3),
                          load.normal > 0 ? format_decimals(degrees(std::atan2(load.shear, load.normal)), 1) : "–"});
  }
  section.parts.emplace_back(table);
  section.parts.emplace_back(
      Paragraph{"Forces are sums of magnitudes over contact points. The mobilised angle is that of their shear over "
                "their normal force; where points slip without cohesion it is the friction angle.",
                Paragraph::Kind::note});
  return section;
}

}  // namespace talus::report
