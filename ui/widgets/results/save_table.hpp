#pragma once

#include <QString>
#include <functional>
#include <string>

class QWidget;

namespace talus {

class Messages;

/// Asks for a file and writes a table into it, which `table` makes; says what was written, or why it was not.
void saveTable(QWidget& over, Messages& messages, const QString& title, const QString& proposedName,
               const std::function<std::string()>& table);

}  // namespace talus
