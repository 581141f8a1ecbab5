#include "study/accuracy/study_run_json.hpp"

#include "base/error.hpp"
#include "io/whole_file.hpp"
#include "study/accuracy/number_or_null.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const ExpectationOutcome& outcome) {
  return {{"computed", outcome.computed}, {"error", outcome.error}, {"reached", outcome.reached}};
}

ExpectationOutcome expectation_of(const Json& json) {
  ExpectationOutcome outcome;
  outcome.computed = json.at("computed").is_null() ? 0 : json.at("computed").get<double>();
  outcome.error = json.at("error").is_null() ? 0 : json.at("error").get<double>();
  outcome.reached = json.at("reached");
  return outcome;
}

Json json_of(const StudyMoment& moment) {
  Json displacements = Json::array(), stresses = Json::array();
  for (const Vec3& u : moment.displacements) displacements.push_back(std::vector<double>(u.begin(), u.end()));
  for (const Voigt& s : moment.stresses) stresses.push_back(std::vector<double>(s.begin(), s.end()));
  return {{"stage", moment.stage}, {"since", moment.since}, {"displacements", displacements}, {"stresses", stresses}};
}

StudyMoment moment_of(const Json& json) {
  StudyMoment moment{json.at("stage"), json.at("since"), {}, {}};
  for (const Json& u : json.at("displacements")) moment.displacements.emplace_back(u.at(0), u.at(1), u.at(2));
  for (const Json& s : json.value("stresses", Json::array()))  // runs made before there were
    moment.stresses.push_back(Voigt::Map(s.get<std::vector<double>>().data()));
  return moment;
}

Json json_of(const StudyTravel& travel) {
  return {{"run_out", travel.run_out},
          {"mean", {travel.mean.x(), travel.mean.y(), travel.mean.z()}},
          {"extent_growth", travel.extent_growth},
          {"start", or_null(travel.start)},
          {"end", or_null(travel.end)}};
}

StudyTravel travel_of(const Json& json) {
  StudyTravel travel;
  travel.run_out = json.at("run_out");
  const Json& mean = json.at("mean");
  travel.mean = Vec3(mean.at(0), mean.at(1), mean.at(2));
  travel.extent_growth = json.at("extent_growth");
  travel.start = number_or_none(json.at("start"));
  travel.end = number_or_none(json.at("end"));
  return travel;
}

Phases phases_of(const Json& json) {
  return {json.at("detect"), json.at("assemble"), json.at("factor"),
          json.at("solve"),  json.at("update"),   json.at("write")};
}

EffectOutcome effect_of(const Json& json) {
  return {json.at("name"),  json.at("active"),      json.at("reason"),    json.at("seconds"),
          json.at("built"), json.at("evaluations"), json.at("assemblies")};
}

StudyStatus status_of(const std::string& word) {
  for (const StudyStatus status : {StudyStatus::completed, StudyStatus::not_converged})
    if (to_string(status) == word) return status;
  return StudyStatus::failed;
}

StudyRun run_of(const Json& json) {
  StudyRun run = run_figures_of(json);
  run.reason = json.at("reason");
  for (const Json& one : json.at("expect")) run.expect.push_back(expectation_of(one));
  for (const Json& one : json.at("moments")) run.moments.push_back(moment_of(one));
  if (json.contains("travel")) run.travel = travel_of(json.at("travel"));  // runs made before it was looked at
  return run;
}

}  // namespace

StudyRun run_figures_of(const Json& json) {
  StudyRun run;
  run.status = status_of(json.at("status"));
  run.cpu_seconds = json.at("cpu_seconds");
  run.wall_seconds = json.at("wall_seconds");
  run.mesh_seconds = json.at("mesh_seconds");
  run.dofs = json.at("dofs");
  run.blocks = json.at("blocks");
  run.tetrahedra = json.at("tetrahedra");
  run.steps = json.at("steps");
  run.iterations = json.at("iterations");
  run.cuts = json.at("cuts");
  run.phases = phases_of(json.at("phases"));
  for (const Json& one : json.at("effects")) run.effects.push_back(effect_of(one));
  return run;
}

Json phases_json(const Phases& phases) {
  return {{"detect", phases.detect}, {"assemble", phases.assemble}, {"factor", phases.factor},
          {"solve", phases.solve},   {"update", phases.update},     {"write", phases.write}};
}

Json effects_json(const std::vector<EffectOutcome>& effects) {
  Json list = Json::array();
  for (const EffectOutcome& effect : effects)
    list.push_back({{"name", effect.name},
                    {"active", effect.active},
                    {"reason", effect.reason},
                    {"seconds", effect.seconds},
                    {"built", effect.built},
                    {"evaluations", effect.evaluations},
                    {"assemblies", effect.assemblies}});
  return list;
}

std::string study_run_text(const StudyRun& run) {
  Json expect = Json::array(), moments = Json::array();
  for (const ExpectationOutcome& outcome : run.expect) expect.push_back(json_of(outcome));
  for (const StudyMoment& moment : run.moments) moments.push_back(json_of(moment));
  const Json json = {{"status", to_string(run.status)},
                     {"reason", run.reason},
                     {"cpu_seconds", run.cpu_seconds},
                     {"wall_seconds", run.wall_seconds},
                     {"mesh_seconds", run.mesh_seconds},
                     {"dofs", run.dofs},
                     {"blocks", run.blocks},
                     {"tetrahedra", run.tetrahedra},
                     {"steps", run.steps},
                     {"iterations", run.iterations},
                     {"cuts", run.cuts},
                     {"expect", expect},
                     {"moments", moments},
                     {"travel", json_of(run.travel)},
                     {"phases", phases_json(run.phases)},
                     {"effects", effects_json(run.effects)}};
  return json.dump(1) + "\n";
}

std::optional<StudyRun> read_study_run(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    return run_of(Json::parse(read_whole_file(file)));
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string(), "is no run of a study that this version understands",
                     "delete it, and go on: it is run again");
  }
}

}  // namespace talus
