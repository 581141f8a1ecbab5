#include "results/summary.hpp"

#include <concepts>
#include <fstream>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

// nlohmann-json writes numbers that are not finite as null, which is what the contract asks for.
Json json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json json(const BlockOutcome& block, const MotionNames& names) {
  Json json_block = {{"name", block.name}, {"body", to_string(block.body)}};
  if (!block.body_reason.empty()) json_block["body_reason"] = block.body_reason;
  json_block.update({{"volume", block.volume},
                     {"relative_volume_change", block.relative_volume_change},
                     {"displacement", json(block.displacement)},
                     {"rotation_degrees", block.rotation_degrees},
                     {"velocity", json(block.velocity)},
                     {"motion", Json::parse(motion_json(block.motion, names))}});
  return json_block;
}

template <class Thing, class Named>
concept Either = std::same_as<std::remove_const_t<Thing>, Named>;

// Calls `field(name, value)` for every field: the one list that writing and reading go by.

void for_each_field(Either<EnergyLedger> auto& energy, auto field) {
  field("kinetic", energy.kinetic);
  field("elastic", energy.elastic);
  field("potential", energy.potential);
  field("contact", energy.contact);
  field("friction_dissipated", energy.friction_dissipated);
  field("damping_dissipated", energy.damping_dissipated);
  field("constraint_work", energy.constraint_work);
  field("integration_loss", energy.integration_loss);
  field("remainder", energy.remainder);
}

void for_each_field(Either<Phases> auto& phases, auto field) {
  field("detect", phases.detect);
  field("assemble", phases.assemble);
  field("factor", phases.factor);
  field("solve", phases.solve);
  field("update", phases.update);
  field("write", phases.write);
}

void for_each_field(Either<EffectOutcome> auto& effect, auto field) {
  field("name", effect.name);
  field("active", effect.active);
  field("reason", effect.reason);
  field("seconds", effect.seconds);
  field("built", effect.built);
  field("evaluations", effect.evaluations);
  field("assemblies", effect.assemblies);
}

void for_each_field(Either<RunWork> auto& work, auto field) {
  field("body_pairs", work.body_pairs);
  field("facet_searches", work.facet_searches);
  field("facet_pairs", work.facet_pairs);
  field("contact_points", work.contact_points);
  field("factorisations", work.factorisations);
  field("dense_factorisations", work.dense_factorisations);
  field("linear_solves", work.linear_solves);
  field("gmres_iterations", work.gmres_iterations);
  field("systems", work.systems);
  field("largest_system", work.largest_system);
  field("block_steps_asleep", work.block_steps_asleep);
  field("wakings", work.wakings);
  field("stress_recoveries", work.stress_recoveries);
  field("correction_limits", work.correction_limits);
  field("impact_sweep_limits", work.impact_sweep_limits);
  field("gmres_limits", work.gmres_limits);
  field("failed_factorisations", work.failed_factorisations);
}

/// Those that are numbers, words or yes and no.
void for_each_plain_field(Either<ConvergenceTrouble> auto& trouble, auto field) {
  field("joint", trouble.joint);
  field("time", trouble.time);
  field("step", trouble.step);
  field("relative_penetration", trouble.relative_penetration);
  field("iterations", trouble.iterations);
  field("most_iterations", trouble.most_iterations);
  field("cuts", trouble.cuts);
  field("ended_run", trouble.ended_run);
  field("advice", trouble.advice);
}

void for_each_field(Either<Event> auto& event, auto field) {
  field("time", event.time);
  field("what", event.what);
}

template <class Thing>
concept Listed = requires(Thing& thing) {
  for_each_field(thing, [](const char*, auto&) {});
};

template <Listed Thing>
Json json(const Thing& thing) {
  Json object = Json::object();
  for_each_field(thing, [&](const char* name, const auto& value) { object[name] = value; });
  return object;
}

Json json(const ConvergenceTrouble& trouble) {
  Json object = {{"blocks", Json::array()},
                 {"cause", to_string(trouble.cause)},
                 {"position", json(trouble.position)},
                 {"rest_position", json(trouble.rest_position)}};
  for (const std::string& block : trouble.blocks)
    if (!block.empty()) object["blocks"].push_back(block);
  for_each_plain_field(trouble, [&](const char* name, const auto& value) { object[name] = value; });
  return object;
}

Json json(const ExpectationOutcome& outcome) {
  const Expectation& expectation = outcome.expectation;
  return {{"quantity", expectation.quantity},
          {"time", expectation.time},
          {"value", expectation.value},
          {"computed", outcome.reached ? Json(outcome.computed) : Json()},
          {"error", outcome.reached ? Json(outcome.error) : Json()},
          {"tolerance", expectation.tolerance},
          {"passed", outcome.passed},
          {"source", expectation.source}};
}

template <class Thing>
Json json(const std::vector<Thing>& things) {
  Json array = Json::array();
  for (const Thing& thing : things) array.push_back(json(thing));
  return array;
}

Json json_of_blocks(const RunReport& report) {
  Json array = Json::array();
  for (const BlockOutcome& block : report.blocks) array.push_back(json(block, report.names));
  return array;
}

Json json_of_contacts(const RunReport& report) {
  return {{"max_penetration", report.max_penetration},
          {"max_relative_penetration", report.max_relative_penetration},
          {"open", report.last_step.open},
          {"stick", report.last_step.stick},
          {"slip", report.last_step.slip}};
}

/// Reads what is there and of the right kind; the rest stays as it is.
template <class Value>
requires(std::is_arithmetic_v<Value> || std::same_as<Value, std::string>) void take(const Json& object,
                                                                                    const char* name, Value& value) {
  const auto found = object.find(name);
  if (found == object.end()) return;
  const bool right = std::same_as<Value, std::string> ? found->is_string()
                     : std::same_as<Value, bool>      ? found->is_boolean()
                                                      : found->is_number();
  if (right) value = found->get<Value>();
}

template <Listed Thing>
void take(const Json& object, const char* name, Thing& thing) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_object()) return;
  for_each_field(thing, [&](const char* field, auto& value) { take(*found, field, value); });
}

template <Listed Thing>
void take(const Json& object, const char* name, std::vector<Thing>& things) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return;
  for (const Json& entry : *found) {
    if (!entry.is_object()) continue;
    Thing& thing = things.emplace_back();
    for_each_field(thing, [&](const char* field, auto& value) { take(entry, field, value); });
  }
}

/// Calls take_item(number, item) for the first `most` of a list, where there is one.
void for_each_item(const Json& object, const char* name, int most, const auto& take_item) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return;
  int number = 0;
  for (const Json& item : *found)
    if (number < most) take_item(number++, item);
}

void take(const Json& object, const char* name, Vec3& vector) {
  for_each_item(object, name, 3, [&](int i, const Json& number) {
    if (number.is_number()) vector[i] = number;
  });
}

void take(const Json& object, ConvergenceTrouble& trouble) {
  for_each_plain_field(trouble, [&](const char* name, auto& value) { take(object, name, value); });
  std::string word;
  take(object, "cause", word);
  for (const TroubleCause cause : {TroubleCause::many_iterations, TroubleCause::missed_contact,
                                   TroubleCause::not_converged, TroubleCause::inverted, TroubleCause::interpenetrating})
    if (word == to_string(cause)) trouble.cause = cause;
  if (word == "found-late") trouble.cause = TroubleCause::missed_contact;  // old words
  if (word == "not-settled") trouble.cause = TroubleCause::not_converged;
  for_each_item(object, "blocks", 2, [&](int i, const Json& block) {
    if (block.is_string()) trouble.blocks[static_cast<std::size_t>(i)] = block;
  });
  take(object, "position", trouble.position);
  take(object, "rest_position", trouble.rest_position);
}

void take(const Json& object, ExpectationOutcome& outcome) {
  Expectation& expectation = outcome.expectation;
  take(object, "quantity", expectation.quantity);
  take(object, "time", expectation.time);
  take(object, "value", expectation.value);
  take(object, "tolerance", expectation.tolerance);
  take(object, "source", expectation.source);
  const auto computed = object.find("computed");
  outcome.reached = computed != object.end() && computed->is_number();
  take(object, "computed", outcome.computed);
  take(object, "error", outcome.error);
  take(object, "passed", outcome.passed);
}

template <class Thing>
requires(!Listed<Thing>) void take(const Json& object, const char* name, std::vector<Thing>& things) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return;
  for (const Json& entry : *found)
    if (entry.is_object()) take(entry, things.emplace_back());
}

void take_contacts(const Json& summary, RunReport& report) {
  const auto found = summary.find("contacts");
  if (found == summary.end() || !found->is_object()) return;
  take(*found, "max_penetration", report.max_penetration);
  take(*found, "max_relative_penetration", report.max_relative_penetration);
  take(*found, "open", report.last_step.open);
  take(*found, "stick", report.last_step.stick);
  take(*found, "slip", report.last_step.slip);
}

std::optional<RunStatus> status_named(const Json& summary) {
  std::string word;
  take(summary, "status", word);
  for (const RunStatus status :
       {RunStatus::completed, RunStatus::stopped, RunStatus::not_converged, RunStatus::interpenetrating})
    if (word == to_string(status)) return status;
  return {};
}

}  // namespace

std::string summary_json(const RunReport& report) {
  const Json summary = {{"version", report.version},
                        {"finished", report.finished},
                        {"status", to_string(report.status)},
                        {"reason", report.reason},
                        {"time", report.time},
                        {"steps", report.steps},
                        {"frames", report.frames},
                        {"iterations", report.iterations},
                        {"cuts", report.cuts},
                        {"wall_seconds", report.wall_seconds},
                        {"threads", report.threads},
                        {"tolerance", report.tolerance},
                        {"blocks", json_of_blocks(report)},
                        {"contacts", json_of_contacts(report)},
                        {"energy", json(report.last_step.energy)},
                        {"effects", json(report.effects)},
                        {"work", json(report.work)},
                        {"phases", json(report.phases)},
                        {"convergence_trouble", json(report.troubles)},
                        {"events", json(report.events)},
                        {"expect", json(report.expect)}};
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::optional<RunReport> read_summary(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const Json summary = Json::parse(stream, nullptr, false);
  const auto status = summary.is_object() ? status_named(summary) : std::nullopt;
  if (!status) return {};
  RunReport report;
  report.status = *status;
  take(summary, "version", report.version);
  take(summary, "finished", report.finished);
  take(summary, "reason", report.reason);
  take(summary, "time", report.time);
  take(summary, "steps", report.steps);
  take(summary, "frames", report.frames);
  take(summary, "iterations", report.iterations);
  take(summary, "cuts", report.cuts);
  take(summary, "wall_seconds", report.wall_seconds);
  take(summary, "threads", report.threads);
  take(summary, "tolerance", report.tolerance);
  take_contacts(summary, report);
  take(summary, "energy", report.last_step.energy);
  take(summary, "effects", report.effects);
  take(summary, "work", report.work);
  take(summary, "phases", report.phases);
  take(summary, summary.contains("struggles") ? "struggles" : "convergence_trouble", report.troubles);  // the old name
  take(summary, "events", report.events);
  take(summary, "expect", report.expect);
  return report;
}

}  // namespace talus
