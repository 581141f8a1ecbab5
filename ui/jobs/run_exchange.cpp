#include "jobs/run_exchange.hpp"

namespace talus {

void RunExchange::report(double fraction, std::string_view what) {
  const std::lock_guard lock(mutex_);
  news_.fraction = fraction;
  news_.what = what;
}

bool RunExchange::cancelled() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

void RunExchange::on_step(const StepReport& step, const HistoryRow& history, double fraction) {
  const std::lock_guard lock(mutex_);
  news_.solving = true;
  news_.fraction = fraction;
  news_.steps.push_back(step);
  news_.history.push_back(history);
}

void RunExchange::on_frame(std::shared_ptr<const Frame> frame) {
  const std::lock_guard lock(mutex_);
  news_.frames.push_back(std::move(frame));
}

void RunExchange::on_effects(const std::vector<EffectOutcome>& effects) {
  const std::lock_guard lock(mutex_);
  news_.effects = effects;
}

void RunExchange::on_troubles(const std::vector<ConvergenceTrouble>& troubles) {
  const std::lock_guard lock(mutex_);
  news_.troubles = troubles;
}

bool RunExchange::go_on() {
  std::unique_lock lock(mutex_);
  woken_.wait(lock, [this] { return stopped_ || !allowed_ || *allowed_ > 0; });
  if (allowed_ && *allowed_ > 0) --*allowed_;
  return !stopped_;
}

void RunExchange::meshed(std::shared_ptr<const BlockSystem> system) {
  const std::lock_guard lock(mutex_);
  news_.system = std::move(system);
  news_.fraction = 0;
  news_.what.clear();
}

void RunExchange::sized(const SceneSize& size) {
  const std::lock_guard lock(mutex_);
  news_.size = size;
}

void RunExchange::pause() {
  const std::lock_guard lock(mutex_);
  allowed_ = 0;
}

void RunExchange::resume() {
  const std::lock_guard lock(mutex_);
  allowed_.reset();
  woken_.notify_all();
}

void RunExchange::allowSteps(int count) {
  const std::lock_guard lock(mutex_);
  allowed_ = allowed_.value_or(0) + count;
  woken_.notify_all();
}

void RunExchange::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  woken_.notify_all();
}

JobNews RunExchange::take() {
  const std::lock_guard lock(mutex_);
  JobNews taken = std::move(news_);
  news_ = {};
  news_.fraction = taken.fraction;
  news_.what = taken.what;
  news_.solving = taken.solving;
  return taken;
}

}  // namespace talus
