#pragma once

#include "widgets/kit/parts.hpp"

namespace talus {

/// What there is to say of one run of a list: a head with its title and verdict, and below it what scrolls.
class OutcomePage : public QWidget {
  Q_OBJECT
 protected:
  OutcomePage();
  /// Empties the page; `chip` is the role of the verdict's label.
  void begin(const QString& title, const char* chip, const QString& verdict);
  void addSentence(const QString& words, const char* role = nullptr);
  QVBoxLayout& content() { return *content_; }

 private:
  QLabel *title_, *verdict_;
  QVBoxLayout* content_;
};

}  // namespace talus
