#include "widgets/verification/known_answers.hpp"

#include "verification/verify_json.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

RunListWords knownAnswerWords() {
  return {
      .list = QObject::tr("Cases with a known answer"),
      .what = QObject::tr("Case"),
      .facts = {},
      .figures = {},
      .goesOn = QObject::tr("Cases are being run"),
      .none = QObject::tr("No case has been run yet"),
      .passed = QObject::tr("%1 of %2 passed"),
      .repeat = QObject::tr("Also on two threads and at 1/10 scale"),
      .repeatTip = QObject::tr("Each case is run twice more: on two threads it must give the same bits, at a tenth of "
                               "the scale the same relative numbers"),
      .file = QStringLiteral("known_answers.json")};
}

std::vector<RunItem> itemsOf(const std::vector<KnownCase>& cases) {
  std::vector<RunItem> items;
  for (const KnownCase& known : cases)
    items.push_back({.title = numbers::inSentence(known.title),
                     .tip = text(known.name),
                     .group = {},
                     .facts = {},
                     .caution = {},
                     .takesLong = known.takes_long});
  return items;
}

}  // namespace

KnownAnswers::KnownAnswers(const std::vector<KnownCase>& cases)
    : ResultList(knownAnswerWords(), itemsOf(cases), cases, new CasePage, Qt::Horizontal) {
  begin();
}

void KnownAnswers::start(const std::vector<std::size_t>& indices, bool repeat) {
  VerifyOptions options;
  options.repeat = repeat;
  startJob(indices, [options](const std::vector<KnownCase>& chosen, Progress& progress, const auto& ended) {
    verify(chosen, options, progress, ended);
  });
}

std::optional<RunVerdict> KnownAnswers::verdict(std::size_t index) const {
  const CaseResult* came = result(index);
  if (!came) return {};
  if (came->passed()) return RunVerdict{true, tr("passed"), QStringLiteral("ok"), theme::Tone::ok, {}, came->seconds};
  return RunVerdict{false, tr("failed"), QStringLiteral("error"), theme::Tone::error, {}, came->seconds};
}

std::string KnownAnswers::json() const { return json_text(results()); }

}  // namespace talus
