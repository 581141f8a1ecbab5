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
  news_.iterations = 0;
  news_.steps.push_back(step);
  news_.history.push_back(history);
}

void RunExchange::on_iteration(double unbalanced) {
  const std::lock_guard lock(mutex_);
  ++news_.iterations;
  news_.unbalanced = unbalanced;
}

void RunExchange::on_frame(std::shared_ptr<const Frame> frame) {
  const std::lock_guard lock(mutex_);
  news_.frames.push_back(std::move(frame));
  news_.moment.reset();
  last_frame_ = std::chrono::steady_clock::now();
}

bool RunExchange::wants_moment() {
  const std::lock_guard lock(mutex_);
  return std::chrono::steady_clock::now() - last_frame_ > between_moments;
}

void RunExchange::on_moment(std::shared_ptr<const Frame> frame) {
  const std::lock_guard lock(mutex_);
  news_.moment = std::move(frame);
  last_frame_ = std::chrono::steady_clock::now();
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
  news_.iterations = taken.iterations;
  news_.unbalanced = taken.unbalanced;
  return taken;
}

}  // namespace talus
