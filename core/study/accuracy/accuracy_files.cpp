#include "study/accuracy/accuracy_files.hpp"

#include <nlohmann/json.hpp>
#include <variant>

#include "model/number_text.hpp"
#include "model/solid_shape.hpp"
#include "model/tolerance_text.hpp"
#include "study/accuracy/number_or_null.hpp"
#include "study/accuracy/setting_json.hpp"
#include "study/accuracy/study_run_json.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

/// In quotes where a comma or a quote would end it.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
  return quoted + '"';
}

std::string cell(const std::optional<double>& value) { return value ? number_text(*value) : std::string(); }

std::string status_of(const AccuracyRow& row) { return row.run ? std::string(to_string(row.run->status)) : "missing"; }

std::string line_of(std::size_t number, const AccuracyRow& row) {
  const StudyRun run = row.run.value_or(StudyRun{});
  const Setting& s = row.setting;
  const std::string cells[] = {std::to_string(number),
                               cell(row.label),
                               body_text(s),
                               std::string(to_string(s.strain)),
                               std::string(to_string(s.integrator)),
                               number_text(s.time_step),
                               number_text(s.static_step),
                               number_text(s.mesh_size),
                               penetration_text(s),
                               tolerance_text(s.tolerance),
                               std::string(to_string(s.scheme)),
                               std::to_string(run.dofs),
                               std::to_string(run.blocks),
                               std::to_string(run.tetrahedra),
                               std::to_string(run.steps),
                               std::to_string(run.iterations),
                               std::to_string(run.cuts),
                               number_text(run.cpu_seconds),
                               number_text(run.wall_seconds),
                               number_text(run.mesh_seconds),
                               cell(row.error),
                               row.error ? number_text(row.error_estimate) : "",
                               cell(row.from_finest),
                               status_of(row),
                               row.pareto ? "yes" : "no",
                               cell(row.note),
                               cell(row.spread),
                               row.spread ? number_text(row.standard_error) : "",
                               std::string(to_string(s.contact)),
                               number_text(s.contact_stiffness)};
  std::string line;
  for (const std::string& one : cells) (line += line.empty() ? "" : ",") += one;
  return line + '\n';
}

Json json_of(int number, const AccuracyRow& row) {
  const StudyRun run = row.run.value_or(StudyRun{});
  Json json = {{"number", number}, {"label", row.label}};
  json.update(setting_json(row.setting));
  json.update({{"dofs", run.dofs},
               {"blocks", run.blocks},
               {"tetrahedra", run.tetrahedra},
               {"steps", run.steps},
               {"iterations", run.iterations},
               {"cuts", run.cuts},
               {"cpu_seconds", run.cpu_seconds},
               {"wall_seconds", run.wall_seconds},
               {"mesh_seconds", run.mesh_seconds},
               {"error", or_null(row.error)},
               {"error_estimate", row.error ? Json(row.error_estimate) : Json()},
               {"from_finest", or_null(row.from_finest)},
               {"spread", or_null(row.spread)},
               {"standard_error", row.spread ? Json(row.standard_error) : Json()},
               {"status", status_of(row)},
               {"pareto", row.pareto},
               {"note", row.note},
               {"phases", phases_json(run.phases)},
               {"effects", effects_json(run.effects)}});
  return json;
}

Json json_of(const AxisOrder& order) {
  const bool has_order = order.fit.convergence == Convergence::converging;
  return {{"axis", to_string(order.axis)},
          {"convergence", to_string(order.fit.convergence)},
          {"order", has_order ? Json(order.fit.order) : Json()},
          {"theory", or_null(order.theory)},
          {"misfit", has_order ? Json(order.fit.misfit) : Json()},
          {"spread", order.fit.spread},
          {"finest_error", order.fit.finest_error},
          {"runs", order.runs},
          {"cut_runs", order.cut_runs}};
}

}  // namespace

std::string accuracy_csv(const AccuracyStudy& study) {
  std::string text =
      "number,label,body,strain,integrator,time_step,static_step,mesh_size,penetration_tolerance,tolerance,scheme,dofs,"
      "blocks,tetrahedra,steps,iterations,cuts,cpu_seconds,wall_seconds,mesh_seconds,error,error_estimate,from_finest,"
      "status,pareto,note,spread,standard_error,contact,contact_stiffness\n";
  for (std::size_t i = 0; i < study.rows.size(); ++i) text += line_of(i, study.rows[i]);
  return text;
}

std::string accuracy_json(const AccuracyStudy& study) {
  Json runs = Json::array(), orders = Json::array(), left_out = Json::array();
  for (std::size_t i = 0; i < study.rows.size(); ++i) runs.push_back(json_of(static_cast<int>(i), study.rows[i]));
  for (const AxisOrder& order : study.orders) orders.push_back(json_of(order));
  for (const LeftOut& one : study.left_out) left_out.push_back({{"what", one.what}, {"reason", one.reason}});
  const auto run_or_null = [](int run) { return run < 0 ? Json() : Json(run); };
  const Json json = {{"project", study.project_name},
                     {"project_file", study.project_file},
                     {"complete", study.complete()},
                     {"measured_against", study.known_answer ? "expect" : "finest"},
                     {"measure", study.known_answer ? Json() : Json(to_string(study.measure))},
                     {"reference", run_or_null(study.reference)},
                     {"reference_error", study.reference_error},
                     {"repeats", study.repeats},
                     {"scatter", or_null(study.scatter)},
                     {"told_apart", study.told_apart ? Json(*study.told_apart) : Json()},
                     {"target", or_null(study.target)},
                     {"recommended", run_or_null(study.recommended)},
                     {"orders", orders},
                     {"left_out", left_out},
                     {"runs", runs}};
  return json.dump(2) + "\n";
}

std::string recommended_project(const AccuracyStudy& study, const StudyPlan& plan,
                                const std::filesystem::path& folder) {
  Project project = under(study.rows.at(static_cast<std::size_t>(study.recommended)).setting, project_of(plan));
  for (Solid& solid : project.solids)
    if (std::string* file = file_of(solid.shape))
      *file = std::filesystem::relative(plan.project_file.parent_path() / *file, folder).string();
  return text_of(project, plan);
}

void write_accuracy_files(const AccuracyStudy& study, const StudyFolder& folder) {
  folder.write("accuracy.csv", accuracy_csv(study));
  folder.write("accuracy.json", accuracy_json(study));
  if (study.recommended >= 0)
    folder.write("recommended.talus", recommended_project(study, folder.plan(), folder.path()));
}

}  // namespace talus
