#include "widgets/results/save_table.hpp"

#include <QCoreApplication>
#include <QFileDialog>
#include <QSaveFile>

#include "base/error.hpp"
#include "session/messages.hpp"

namespace talus {

void saveTable(QWidget& over, Messages& messages, const QString& title, const QString& proposedName,
               const std::function<std::string()>& table) {
  const QString name = QFileDialog::getSaveFileName(&over, title, proposedName,
                                                    QCoreApplication::translate("saveTable", "Tables (*.csv)"));
  if (name.isEmpty()) return;
  QSaveFile file(name);
  const std::string text = table();
  if (file.open(QIODevice::WriteOnly) && file.write(text.data(), static_cast<qint64>(text.size())) >= 0 &&
      file.commit())
    messages.log(QCoreApplication::translate("saveTable", "wrote %1").arg(name));
  else
    messages.add(problemOf(InputError(name.toStdString(), file.errorString().toStdString(), "choose another place"),
                           Problem::Of::picture));
}

}  // namespace talus
