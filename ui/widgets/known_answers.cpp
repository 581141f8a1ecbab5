#include "widgets/known_answers.hpp"

#include "study/verify_json.hpp"
#include "widgets/case_page.hpp"

namespace talus {

namespace {

RunListWords words() {
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
    items.push_back({.title = QString::fromStdString(known.title),
                     .tip = QString::fromStdString(known.name),
                     .group = {},
                     .facts = {},
                     .caution = {},
                     .takesLong = known.takes_long});
  return items;
}

}  // namespace

KnownAnswers::KnownAnswers(std::vector<KnownCase> cases) : KnownAnswers(std::move(cases), new CasePage) {}

KnownAnswers::KnownAnswers(std::vector<KnownCase> cases, CasePage* page)
    : RunList(words(), itemsOf(cases), page, Qt::Horizontal), cases_(std::move(cases)), page_(page) {
  begin();
}

void KnownAnswers::start(const std::vector<std::size_t>& indices, bool repeat) {
  std::vector<KnownCase> chosen;
  for (const std::size_t index : indices) chosen.push_back(cases_[index]);
  VerifyOptions options;
  options.repeat = repeat;
  job().start<CaseResult>([chosen = std::move(chosen), options](
                              Progress& progress, const auto& ended) { verify(chosen, options, progress, ended); },
                          [this](const CaseResult& result) {
                            results_.insert_or_assign(result.name, result);
                            takeEnded();
                          });
}

const CaseResult* KnownAnswers::result(std::size_t index) const {
  const auto found = results_.find(cases_[index].name);
  return found == results_.end() ? nullptr : &found->second;
}

std::optional<RunVerdict> KnownAnswers::verdict(std::size_t index) const {
  const CaseResult* came = result(index);
  if (!came) return {};
  if (came->passed()) return RunVerdict{true, tr("passed"), QStringLiteral("ok"), theme::Tone::ok, {}, came->seconds};
  return RunVerdict{false, tr("failed"), QStringLiteral("error"), theme::Tone::error, {}, came->seconds};
}

void KnownAnswers::showPage(std::size_t index) { page_->show(cases_[index], result(index)); }

std::vector<CaseResult> KnownAnswers::results() const {
  std::vector<CaseResult> ordered;
  for (std::size_t i = 0; i < cases_.size(); ++i)
    if (const CaseResult* came = result(i)) ordered.push_back(*came);
  return ordered;
}

std::string KnownAnswers::json() const { return json_text(results()); }

}  // namespace talus
