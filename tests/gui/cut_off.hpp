#pragma once

#include <QWidget>
#include <string>
#include <vector>

namespace talus {

/// The words that cannot be read as they stand in the window and the dialogs over it: cut off at a side, squeezed, or
/// under what lies beside them; and dialogs that do not fit into the window. What scrolls is not meant, nor what is out
/// of sight, nor what the user has written (names, cells of tables) where its tooltip has it whole.
std::vector<std::string> cutOff(const QWidget& window);

}  // namespace talus
