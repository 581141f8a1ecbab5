#include "study/accuracy/accuracy_reader.hpp"

#include "base/error.hpp"
#include "io/whole_file.hpp"
#include "study/accuracy/number_or_null.hpp"
#include "study/accuracy/setting_json.hpp"
#include "study/accuracy/study_run_json.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

int run_or_none(const Json& json) { return json.is_null() ? -1 : json.get<int>(); }

AccuracyRow row_of(const Json& json) {
  AccuracyRow row;
  row.setting = setting_of(json);
  row.label = json.at("label");
  if (json.at("status") != "missing") row.run = run_figures_of(json);
  row.error = number_or_none(json.at("error"));
  row.error_estimate = number_or_none(json.at("error_estimate")).value_or(0);
  row.from_finest = number_or_none(json.at("from_finest"));
  row.spread = number_or_none(json.value("spread", Json()));  // studies made before there were repeats
  row.standard_error = number_or_none(json.value("standard_error", Json())).value_or(0);
  row.pareto = json.at("pareto");
  row.note = json.at("note");
  return row;
}

AxisOrder order_of(const Json& json) {
  AxisOrder order;
  for (const StudyAxis axis : sized_axes)
    if (json.at("axis") == to_string(axis)) order.axis = axis;
  order.theory = number_or_none(json.at("theory"));
  for (const Convergence convergence :
       {Convergence::converging, Convergence::exact, Convergence::not_monotone, Convergence::order_assumed,
        Convergence::not_expected, Convergence::within_scatter})
    if (json.at("convergence") == to_string(convergence)) order.fit.convergence = convergence;
  order.fit.order = number_or_none(json.at("order")).value_or(0);
  order.fit.misfit = number_or_none(json.at("misfit")).value_or(0);
  order.fit.spread = json.at("spread");
  order.fit.finest_error = json.at("finest_error");
  order.runs = json.at("runs").get<std::vector<int>>();
  order.cut_runs = json.at("cut_runs").get<std::vector<int>>();
  return order;
}

AccuracyStudy study_of(const Json& json) {
  AccuracyStudy study;
  study.project_name = json.at("project");
  study.project_file = json.at("project_file");
  study.known_answer = json.at("measured_against") == "expect";
  study.reference = run_or_none(json.at("reference"));
  study.reference_error = json.at("reference_error");
  if (const Json measure = json.value("measure", Json()); !measure.is_null())  // studies made before there was a choice
    study.measure = study_measure_from(measure);
  study.repeats = json.value("repeats", 1);
  study.scatter = number_or_none(json.value("scatter", Json()));
  if (const Json told = json.value("told_apart", Json()); !told.is_null()) study.told_apart = told.get<bool>();
  for (const Json& row : json.at("runs")) study.rows.push_back(row_of(row));
  for (const Json& order : json.at("orders")) study.orders.push_back(order_of(order));
  for (const Json& one : json.at("left_out")) study.left_out.push_back({one.at("what"), one.at("reason")});
  study.target = number_or_none(json.at("target"));
  study.recommended = run_or_none(json.at("recommended"));
  return study;
}

}  // namespace

AccuracyStudy read_accuracy_json(const std::filesystem::path& file) {
  const std::string text = read_whole_file(file);
  try {
    return study_of(Json::parse(text));
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string(), "is no accuracy.json that this version understands",
                     "make the study again with talus-cli study accuracy");
  }
}

}  // namespace talus
