#include "results/summary.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

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

Json json(const EnergyLedger& energy) {
  return {{"kinetic", energy.kinetic},
          {"elastic", energy.elastic},
          {"potential", energy.potential},
          {"contact", energy.contact},
          {"friction_dissipated", energy.friction_dissipated},
          {"damping_dissipated", energy.damping_dissipated},
          {"constraint_work", energy.constraint_work},
          {"integration_loss", energy.integration_loss},
          {"remainder", energy.remainder}};
}

Json json(const Phases& phases) {
  return {{"detect", phases.detect}, {"assemble", phases.assemble}, {"factor", phases.factor},
          {"solve", phases.solve},   {"update", phases.update},     {"write", phases.write}};
}

Json json(const EffectOutcome& effect) {
  return {{"name", effect.name}, {"active", effect.active}, {"reason", effect.reason}, {"seconds", effect.seconds}};
}

Json json(const Event& event) { return {{"time", event.time}, {"what", event.what}}; }

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

}  // namespace

std::string summary_json(const RunReport& report) {
  const Json summary = {{"status", to_string(report.status)},
                        {"reason", report.reason},
                        {"time", report.time},
                        {"steps", report.steps},
                        {"frames", report.frames},
                        {"iterations", report.iterations},
                        {"cuts", report.cuts},
                        {"wall_seconds", report.wall_seconds},
                        {"threads", report.threads},
                        {"blocks", json_of_blocks(report)},
                        {"contacts", json_of_contacts(report)},
                        {"energy", json(report.last_step.energy)},
                        {"effects", json(report.effects)},
                        {"phases", json(report.phases)},
                        {"events", json(report.events)},
                        {"expect", json(report.expect)}};
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::vector<Event> read_events(const std::filesystem::path& file) {
  std::ifstream stream(file);
  const Json summary = Json::parse(stream, nullptr, false);
  std::vector<Event> events;
  if (!summary.is_object() || !summary.contains("events") || !summary["events"].is_array()) return events;
  for (const Json& event : summary["events"])
    if (event.is_object() && event.contains("what") && event["what"].is_string())
      events.push_back({event.value("time", 0.0), event["what"].get<std::string>()});
  return events;
}

}  // namespace talus
