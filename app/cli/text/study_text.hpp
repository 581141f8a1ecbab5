#pragma once

#include <string>

#include "study/accuracy/accuracy.hpp"

namespace talus::cli {

/// The table of runs, cheapest first, then orders, what was left out, and the recommendation.
std::string study_text(const AccuracyStudy& study);

/// "Order in the time step: 0.98 (theory 1 in vibration), fits within 2 %; answers differ by up to 3 %."
std::string order_text(const AxisOrder& order);

/// "Errors are of means of 5 runs, …", and whether settings can be told apart; empty where each was run once.
std::string repeats_text(const AccuracyStudy& study);

/// Which run the target asks for, or that none meets it. Of a study with a target.
std::string recommendation_text(const AccuracyStudy& study);

}  // namespace talus::cli
