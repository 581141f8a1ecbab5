#include "widgets/verification/hard_case_list.hpp"

#include "verification/verify_hard_cases_json.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

RunListWords hardCaseWords() {
  return {.list = QObject::tr("Hard cases, chosen to break contact codes"),
          .what = QObject::tr("Case"),
          .facts = {QObject::tr("Must come to")},
          .figures = {QObject::tr("Ending"), QObject::tr("Penetration"), QObject::tr("Growth"),
                      QObject::tr("Iterations"), QObject::tr("At most"), QObject::tr("Cuts")},
          .goesOn = QObject::tr("Cases are being run"),
          .none = QObject::tr("No case has been run yet"),
          .passed = QObject::tr("%1 of %2 hold"),
          .repeat = QObject::tr("Also again, on one and two threads"),
          .repeatTip = QObject::tr("Each case is run twice more: on one thread and on two it must give the same bits"),
          .file = QStringLiteral("hard_cases.json")};
}

QString expectationsOf(const HardCase& hardCase) {
  QStringList expectations;
  for (const HardCaseExpectation& expectation : hardCase.expected)
    expectations << numbers::inSentence(expectation.words);
  return expectations.join(QStringLiteral("; "));
}

std::vector<RunItem> itemsOf(const std::vector<HardCase>& cases) {
  std::vector<RunItem> items;
  for (const HardCase& hardCase : cases)
    items.push_back({.title = numbers::inSentence(hardCase.title),
                     .tip = text(hardCase.name),
                     .group = text(hardCase.group),
                     .facts = {expectationsOf(hardCase)},
                     .caution = numbers::inSentence(hardCase.shortfall),
                     .takesLong = hardCase.takes_long});
  return items;
}

QStringList figuresOf(const Trial& trial) {
  return {text(std::string(to_string(trial.ending))), numbers::figure(trial.penetration, 2),
          numbers::figure(trial.energy_growth, 2),    numbers::figure(trial.iterations_per_step(), 3),
          numbers::whole(trial.most_iterations),      numbers::whole(trial.cuts)};
}

}  // namespace

HardCaseList::HardCaseList(const std::vector<HardCase>& cases)
    : ResultList(hardCaseWords(), itemsOf(cases), cases, new TrialPage, Qt::Vertical) {
  begin();
}

void HardCaseList::start(const std::vector<std::size_t>& indices, bool repeat) {
  TrialOptions options;
  if (repeat) options.repeat_on = {1, 2};
  startJob(indices, [options](const std::vector<HardCase>& chosen, Progress& progress, const auto& ended) {
    verify_hard_cases(chosen, options, progress, ended);
  });
}

std::optional<RunVerdict> HardCaseList::verdict(std::size_t index) const {
  const Trial* came = result(index);
  if (!came) return {};
  RunVerdict verdict{came->passed(),  tr("holds"),      QStringLiteral("ok"),
                     theme::Tone::ok, figuresOf(*came), came->seconds};
  if (came->passed()) return verdict;
  const bool known = !came->known_shortfall.empty();
  verdict.words = known ? tr("falls short, known") : tr("does not hold");
  verdict.icon = known ? QStringLiteral("warning") : QStringLiteral("error");
  verdict.tone = known ? theme::Tone::warn : theme::Tone::error;
  return verdict;
}

std::string HardCaseList::json() const { return json_text(results()); }

}  // namespace talus
