#include "session/messages.hpp"

#include "base/error.hpp"
#include "document/schema.hpp"

namespace talus {

namespace {

/// What the core advises in options of the command line and in keys of the file, as it is done in the window.
QString inTheWindow(QString remedy) {
  remedy.replace(QStringLiteral("choose another --out"),
                 QObject::tr("save the project in another folder, where its results will lie beside it"));
  return schema::inWordsOfForms(remedy.remove(QStringLiteral(", or allow it with --allow-outside")));
}

}  // namespace

Problem problemOf(const InputError& error, Problem::Severity severity) {
  return {.severity = severity,
          .place = QString::fromStdString(error.place()),
          .problem = schema::inWordsOfForms(QString::fromStdString(error.problem())),
          .remedy = inTheWindow(QString::fromStdString(error.remedy()))};
}

Problem problemOf(const InputError& error, Problem::Of of) {
  Problem problem = problemOf(error);
  problem.of = of;
  return problem;
}

Problem problemIn(const std::filesystem::path& file, const InputError& error) {
  Problem problem = problemOf(error, Problem::Of::file);
  problem.place = QString::fromStdString(file.string()) + QStringLiteral(": ") + problem.place;
  return problem;
}

void Messages::add(const Problem& problem) {
  problems_.push_back(problem);
  problems_.back().number = ++added_;
  log(QStringLiteral("%1: %2; %3").arg(problem.place, problem.problem, problem.remedy));
  emit problemAdded(problems_.back());
  emit problemsChanged();
}

void Messages::clear() {
  problems_.clear();
  emit problemsChanged();
}

void Messages::settle(Problem::Of of) {
  const auto gone = std::erase_if(problems_, [of](const Problem& problem) { return problem.of == of; });
  if (gone > 0) emit problemsChanged();
}

}  // namespace talus
