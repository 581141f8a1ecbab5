#pragma once

#include "command.hpp"

// One file a kind of study; each adds its command to `study`.
namespace talus::cli {

void add_accuracy_study(CLI::App& study, Invocation& invocation);
void add_case_study(CLI::App& study, Invocation& invocation);

}  // namespace talus::cli
