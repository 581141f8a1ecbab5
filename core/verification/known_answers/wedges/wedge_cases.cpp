#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

std::vector<KnownCase> wedge_cases() {
  const std::string tests = "Yeung, Jiang & Sun 2003; Tables 1 and 2 of the paper";
  return {
      {.name = "sliding_wedge",
       .title = "Wedge on two planes: acceleration and factor of safety",
       .source = "(N1 + N2) tan φ / T and g sin ψ (1 − factor); Hoek & Bray 1981",
       .of_any_body = true,
       .run = sliding_wedge_case},
      {.name = "critical_wedge",
       .title = "Wedge between 40°/130° and 60°/220°: plunge and critical friction angle",
       .source = "Hoek & Bray 1977; verification problem of 3DEC",
       .of_any_body = true,
       .run = critical_wedge_case},
      {.name = "roof_wedge",
       .title = "Wedge of three joints in a roof, held by horizontal stress",
       .source = "Goodman, Shi & Boyle 1982; verification problem of 3DEC",
       .of_any_body = true,
       .run = roof_wedge_case},
      {.name = "wedge_tests",
       .title = "65 wedge tests on a tilting table",
       .source = tests + "; limit equilibrium",
       .thinned = true,
       .of_any_body = true,
       .run = wedge_tests_case},
      {.name = "wedge_friction_sweep",
       .title = "65 wedge tests at friction angles from 24° to 34°",
       .source = tests,
       .takes_long = true,
       .thinned = true,
       .of_any_body = true,
       .run = wedge_friction_sweep},
  };
}

}  // namespace talus
