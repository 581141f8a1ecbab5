#pragma once

#include <QMenu>

namespace talus {

class Messages;

/// The languages that the window can speak. Another one is spoken from the next start on.
class LanguageMenu : public QMenu {
  Q_OBJECT
 public:
  LanguageMenu(Messages& messages, QWidget* parent);

 private:
  void add(const QString& words, const QString& code);
  Messages& messages_;
};

}  // namespace talus
