#pragma once

#include <stdexcept>
#include <string>

#include "verification/known_answers/wedges/wedge_test_table.hpp"

namespace talus::test {

/// The row "B1-60-18.3" of the wedge tests.
inline const WedgeTest& wedge_row(const std::string& name) {
  for (const WedgeTest& test : wedge_tests())
    if (test.name() == name) return test;
  throw std::out_of_range(name);
}

}  // namespace talus::test
