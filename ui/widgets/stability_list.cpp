#include "widgets/stability_list.hpp"

#include "study/verify_stability_json.hpp"
#include "widgets/numbers.hpp"
#include "widgets/trial_page.hpp"

namespace talus {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

RunListWords words() {
  return {.list = QObject::tr("Scenes chosen to break contact codes"),
          .what = QObject::tr("Scene"),
          .facts = {QObject::tr("Must come to")},
          .figures = {QObject::tr("Ending"), QObject::tr("Penetration"), QObject::tr("Growth"),
                      QObject::tr("Iterations"), QObject::tr("At most"), QObject::tr("Cuts")},
          .goesOn = QObject::tr("Scenes are being run"),
          .none = QObject::tr("No scene has been run yet"),
          .passed = QObject::tr("%1 of %2 hold"),
          .repeat = QObject::tr("Also again, on one and two threads"),
          .repeatTip = QObject::tr("Each scene is run twice more: on one thread and on two it must give the same bits"),
          .file = QStringLiteral("stability.json")};
}

QString demandsOf(const StabilityScene& scene) {
  QStringList demands;
  for (const Demand& demand : scene.expected) demands << text(demand.words);
  return demands.join(QStringLiteral("; "));
}

std::vector<RunItem> itemsOf(const std::vector<StabilityScene>& scenes) {
  std::vector<RunItem> items;
  for (const StabilityScene& scene : scenes)
    items.push_back({.title = text(scene.title),
                     .tip = text(scene.name),
                     .group = text(scene.group),
                     .facts = {demandsOf(scene)},
                     .caution = text(scene.shortfall),
                     .takesLong = scene.takes_long});
  return items;
}

QStringList figuresOf(const Trial& trial) {
  return {text(std::string(to_string(trial.ending))), numbers::figure(trial.penetration, 2),
          numbers::figure(trial.energy_growth, 2),    numbers::figure(trial.iterations_per_step(), 3),
          numbers::whole(trial.most_iterations),      numbers::whole(trial.cuts)};
}

}  // namespace

StabilityList::StabilityList(std::vector<StabilityScene> scenes) : StabilityList(std::move(scenes), new TrialPage) {}

StabilityList::StabilityList(std::vector<StabilityScene> scenes, TrialPage* page)
    : RunList(words(), itemsOf(scenes), page, Qt::Vertical), scenes_(std::move(scenes)), page_(page) {
  begin();
}

void StabilityList::start(const std::vector<std::size_t>& indices, bool repeat) {
  std::vector<StabilityScene> chosen;
  for (const std::size_t index : indices) chosen.push_back(scenes_[index]);
  TrialOptions options;
  options.repeat = repeat;
  job().start<Trial>([chosen = std::move(chosen), options](
                         Progress& progress, const auto& ended) { verify_stability(chosen, options, progress, ended); },
                     [this](const Trial& trial) {
                       trials_.insert_or_assign(trial.name, trial);
                       takeEnded();
                     });
}

const Trial* StabilityList::trial(std::size_t index) const {
  const auto found = trials_.find(scenes_[index].name);
  return found == trials_.end() ? nullptr : &found->second;
}

std::optional<RunVerdict> StabilityList::verdict(std::size_t index) const {
  const Trial* came = trial(index);
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

void StabilityList::showPage(std::size_t index) { page_->show(scenes_[index], trial(index)); }

std::vector<Trial> StabilityList::trials() const {
  std::vector<Trial> ordered;
  for (std::size_t i = 0; i < scenes_.size(); ++i)
    if (const Trial* came = trial(i)) ordered.push_back(*came);
  return ordered;
}

std::string StabilityList::json() const { return json_text(trials()); }

}  // namespace talus
