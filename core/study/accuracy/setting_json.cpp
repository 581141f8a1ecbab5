#include "study/accuracy/setting_json.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

template <typename Kind>
Kind kind_of(const Json& word, std::initializer_list<Kind> kinds) {
  for (const Kind kind : kinds)
    if (to_string(kind) == word.get<std::string>()) return kind;
  return *kinds.begin();
}

}  // namespace

Json setting_json(const Setting& setting) {
  return {{"body", setting.body ? Json(to_string(*setting.body)) : Json()},
          {"strain", to_string(setting.strain)},
          {"integrator", to_string(setting.integrator)},
          {"time_step", setting.time_step},
          {"static_step", setting.static_step},
          {"mesh_size", setting.mesh_size},
          {"penetration_tolerance", setting.penetration_tolerance ? Json(*setting.penetration_tolerance) : Json()},
          {"tolerance", setting.tolerance},
          {"scheme", to_string(setting.scheme)},
          {"contact", to_string(setting.contact)},
          {"contact_stiffness", setting.contact_stiffness}};
}

Setting setting_of(const Json& json) {
  Setting setting;
  if (const Json& body = json.at("body"); !body.is_null())
    setting.body =
        kind_of(body, {BodyKind::tetrahedra, BodyKind::affine, BodyKind::rigid, BodyKind::fixed, BodyKind::automatic});
  setting.strain = kind_of(json.at("strain"), {Strain::corotational, Strain::incremental});
  setting.integrator = kind_of(json.at("integrator"),
                               {Integrator::newmark, Integrator::constant_acceleration, Integrator::generalized_alpha});
  setting.time_step = json.at("time_step");
  setting.static_step = json.value("static_step", 1.0);  // studies made before there were others
  setting.mesh_size = json.at("mesh_size");
  if (const Json& tolerance = json.at("penetration_tolerance"); !tolerance.is_null())
    setting.penetration_tolerance = tolerance.get<double>();
  setting.tolerance = json.value("tolerance", reference_tolerance.value);  // studies made before there were others
  if (json.contains("scheme")) setting.scheme = kind_of(json.at("scheme"), {Preset::talus, Preset::paper});
  setting.contact = settings_of(setting.scheme).contact;  // of studies made before it was an axis
  if (json.contains("contact"))
    setting.contact = kind_of(json.at("contact"), {ContactModel::area, ContactModel::facet_wise});
  setting.contact_stiffness = json.value("contact_stiffness", 1.0);
  return setting;
}

}  // namespace talus
