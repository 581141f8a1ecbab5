#include "session/compared_results.hpp"

#include <algorithm>

#include "render/views/view_file.hpp"
#include "results/folder.hpp"
#include "session/messages.hpp"
#include "session/playback.hpp"

namespace talus {

ComparedRun::ComparedRun(const std::filesystem::path& folder, Playback& playback) : playback_(playback) {
  connect(&loader_, &ResultsLoader::opened, this, [this](const auto& index) {
    index_ = index;
    emit opened();
    follow();
  });
  connect(&loader_, &ResultsLoader::frameReady, this, [this](const auto& frame) {
    frame_ = frame;
    emit frameChanged();
  });
  connect(&loader_, &ResultsLoader::failed, this, &ComparedRun::failed);
  connect(&playback, &Playback::frameChanged, this, &ComparedRun::follow);
  loader_.open(folder);
}

void ComparedRun::follow() {
  if (index_ && playback_.frame() && !index_->frame_times.empty())
    loader_.requestFrame(nearestFrame(index_->frame_times, playback_.time()));
}

ComparedResults::ComparedResults(Playback& playback, Messages& messages) : playback_(playback), messages_(messages) {
  connect(&playback, &Playback::framesChanged, this, [this] {
    if (playback_.times().empty()) closeAll();
  });
}

void ComparedResults::open(const std::filesystem::path& folder) {
  constexpr std::size_t most = 3;
  if (asked_.size() == most) {
    messages_.add(problemOf(InputError(folder.string(), "three results are compared with those that are open at most",
                                       "end one of the comparisons first"),
                            Problem::Of::results));
    return;
  }
  ask(folder);
}

void ComparedResults::show(const std::vector<ViewBeside>& beside) {
  closeAll();
  for (const ViewBeside& one : beside)
    if (const auto run = ask(one.results); one.over) setOver(*run, true);
}

std::shared_ptr<ComparedRun> ComparedResults::ask(const std::filesystem::path& folder) {
  const auto run = std::make_shared<ComparedRun>(folder, playback_);
  asked_.push_back(run);
  // Queued: it may be let go by what it says.
  connect(run.get(), &ComparedRun::opened, this, &ComparedResults::update, Qt::QueuedConnection);
  connect(
      run.get(), &ComparedRun::failed, this,
      [this, run = std::weak_ptr(run)](const InputError& error) {
        messages_.add(problemOf(error, Problem::Of::results));
        if (const auto one = run.lock(); one && !one->results()) close(*one);
      },
      Qt::QueuedConnection);
  return run;
}

void ComparedResults::setOver(const ComparedRun& run, bool over) {
  if (isOver(run) == over) return;
  over_ = over ? &run : nullptr;
  emit overChanged();
}

void ComparedResults::update() {
  std::vector<std::shared_ptr<ComparedRun>> open;
  std::ranges::copy_if(asked_, std::back_inserter(open), [](const auto& run) { return run->results() != nullptr; });
  if (open == runs_) return;
  const auto kept = std::exchange(runs_, std::move(open));  // until nobody shows one that went
  emit changed();
}

void ComparedResults::close(const ComparedRun& run) {
  setOver(run, false);
  std::erase_if(asked_, [&run](const auto& one) { return one.get() == &run; });
  update();
}

void ComparedResults::closeAll() {
  if (over_) setOver(*over_, false);
  asked_.clear();
  update();
}

std::vector<std::string> ComparedResults::names() const {
  std::vector<std::filesystem::path> folders{playback_.folder()};
  for (const auto& one : runs_) folders.push_back(one->results()->folder);
  return names_of_results(folders);
}

QString ComparedResults::nameOf(const ComparedRun& run) const {
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (runs_[i].get() == &run) return QString::fromStdString(names()[i + 1]);
  return {};
}

QString ComparedResults::nameOfOpen() const { return QString::fromStdString(names().front()); }

}  // namespace talus
