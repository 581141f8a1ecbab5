#include "widgets/kit/language.hpp"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <algorithm>
#include <clocale>

#include "render/paint/picture_words.hpp"

namespace talus::language {

namespace {

const QString key = QStringLiteral("language"), english = QStringLiteral("en");
QString spoken = english;

bool isKnown(const QString& code) {
  return std::ranges::any_of(all(), [&](const Language& one) { return one.code == code; });
}

QString ofSystem() {
  for (const QString& tag : QLocale::system().uiLanguages())
    if (const QString code = tag.section(u'-', 0, 0); isKnown(code)) return code;
  return english;
}

}  // namespace

const std::vector<Language>& all() {
  static const std::vector<Language> languages{{english, QStringLiteral("English")},
                                               {QStringLiteral("de"), QStringLiteral("Deutsch")}};
  return languages;
}

QString chosen() { return QSettings().value(key).toString(); }

void choose(const QString& code) { QSettings().setValue(key, code); }

bool install(const QString& wanted) {
  static QTranslator own, ofQt;
  QString code = wanted;
  if (code.isEmpty()) code = chosen();
  if (code.isEmpty()) code = ofSystem();
  const bool known = isKnown(code);
  for (auto* translator : {&own, &ofQt}) QCoreApplication::removeTranslator(translator);
  spoken = known ? code : english;
  translate_pictures({});
  if (spoken == english) return known;
  // Qt's own dialogs where Debian's qt6-translations-l10n is installed.
  if (ofQt.load(QStringLiteral("qtbase_") + spoken, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&ofQt);
  if (own.load(QStringLiteral(":/translations/talus_%1.qm").arg(spoken))) QCoreApplication::installTranslator(&own);
  translate_pictures([](std::string_view words) {
    return QCoreApplication::translate("picture", std::string(words).c_str()).toStdString();
  });
  return known;
}

QString now() { return spoken; }

void keepDecimalPoint() { std::setlocale(LC_NUMERIC, "C"); }

}  // namespace talus::language
