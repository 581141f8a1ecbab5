#include "orientation/dxf_joints.hpp"

#include <charconv>
#include <map>
#include <set>

#include "base/error.hpp"
#include "orientation/fitted_plane.hpp"

namespace talus {
namespace {

/// A value of the file behind the code that says what it is (AutoCAD's DXF reference, "group codes").
struct Group {
  int code = 0;
  std::string_view value;
  int line = 0;  ///< of the code, from 1
};

/// What begins with a group of code 0: its name, and its groups.
struct Entity {
  std::string_view name;
  int line = 0;
  std::vector<Group> groups;
};

constexpr int name_code = 0, layer_code = 8, flags_code = 70, header_code = 9;

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

InputError no_drawing(int line, const std::string& problem) {
  return {"drawing, line " + std::to_string(line), problem, "save the drawing as ASCII DXF"};
}

template <class Number>
Number number_of(const Group& group) {
  Number value{};
  const auto [end, error] = std::from_chars(group.value.data(), group.value.data() + group.value.size(), value);
  if (error != std::errc() || end != group.value.data() + group.value.size())
    throw no_drawing(group.line + 1, "\"" + std::string(group.value) + "\" is no number");
  return value;
}

std::vector<Group> groups_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    lines.push_back(without_blanks(text.substr(0, end)));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  if (lines.empty() || lines.front().starts_with("AutoCAD Binary DXF"))
    throw no_drawing(1, lines.empty() ? "it is empty" : "it is a binary DXF");
  std::vector<Group> groups;
  for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
    const int number = static_cast<int>(i) + 1;
    groups.push_back({number_of<int>({0, lines[i], number - 1}), lines[i + 1], number});
  }
  return groups;
}

std::vector<Entity> entities_of(const std::vector<Group>& groups) {
  std::vector<Entity> entities;
  for (const Group& group : groups) {
    if (group.code == name_code)
      entities.push_back({group.value, group.line, {}});
    else if (!entities.empty())
      entities.back().groups.push_back(group);
  }
  return entities;
}

/// Metres per unit of the drawing, by the code of $INSUNITS.
double scale_of(const std::vector<Group>& groups) {
  static const std::map<int, double> metres{{1, 0.0254}, {2, 0.3048}, {4, 1e-3}, {5, 1e-2}, {6, 1.0}, {7, 1e3}};
  for (std::size_t i = 0; i + 1 < groups.size(); ++i)
    if (groups[i].code == header_code && groups[i].value == "$INSUNITS")
      if (const auto found = metres.find(number_of<int>(groups[i + 1])); found != metres.end()) return found->second;
  return 1;
}

std::string layer_of(const Entity& entity) {
  for (const Group& group : entity.groups)
    if (group.code == layer_code) return std::string(group.value);
  return {};
}

int flags_of(const Entity& entity) {
  for (const Group& group : entity.groups)
    if (group.code == flags_code) return number_of<int>(group);
  return 0;
}

/// The `corner`-th point of an entity: its coordinates have the codes 10, 20 and 30 more.
Vec3 point_of(const Entity& entity, int corner) {
  Vec3 point = Vec3::Zero();
  for (const Group& group : entity.groups)
    for (int axis = 0; axis < 3; ++axis)
      if (group.code == 10 * (axis + 1) + corner) point[axis] = number_of<double>(group);
  return point;
}

/// In order; a triangle has its third corner twice, a closed line its first.
std::vector<Vec3> without_repetition(const std::vector<Vec3>& points) {
  std::vector<Vec3> corners;
  for (const Vec3& point : points)
    if (corners.empty() || (point != corners.back() && point != corners.front())) corners.push_back(point);
  return corners;
}

JointLine joint_line(int line, const std::string& layer, std::vector<Vec3> corners, double scale) {
  JointLine read{line, {}, {}, {}};
  for (Vec3& corner : corners) corner *= scale;
  try {
    const FittedPlane fit = fitted_plane(corners, "corners");
    read.joint = MeasuredJoint{.plane = upright(fit.plane), .set = layer, .at = fit.through, .corners = corners};
  } catch (const InputError& error) {
    read.problems.push_back({error.place(), error.problem(), "draw the face with corners that are apart"});
  }
  return read;
}

constexpr int three_d_line = 8, mesh_of_points = 16 + 64;  // flags of a POLYLINE

}  // namespace

JointTable read_dxf_joints(std::string_view text) {
  const std::vector<Group> groups = groups_of(text);
  const std::vector<Entity> entities = entities_of(groups);
  const double scale = scale_of(groups);
  JointTable table{{"set", "dip", "dip direction", "x", "y", "z"}, {}, {}, {}};
  std::set<std::string> left_out;
  bool in_entities = false;
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const Entity& entity = entities[i];
    if (entity.name == "SECTION") {
      in_entities = !entity.groups.empty() && entity.groups.front().value == "ENTITIES";
    } else if (!in_entities || entity.name == "ENDSEC") {
      in_entities = false;
    } else if (entity.name == "3DFACE") {
      const std::vector<Vec3> points{point_of(entity, 0), point_of(entity, 1), point_of(entity, 2),
                                     point_of(entity, 3)};
      table.lines.push_back(joint_line(entity.line, layer_of(entity), without_repetition(points), scale));
    } else if (entity.name == "POLYLINE" && (flags_of(entity) & three_d_line) && !(flags_of(entity) & mesh_of_points)) {
      std::vector<Vec3> points;
      while (i + 1 < entities.size() && entities[i + 1].name == "VERTEX") points.push_back(point_of(entities[++i], 0));
      table.lines.push_back(joint_line(entity.line, layer_of(entity), without_repetition(points), scale));
    } else if (entity.name != "VERTEX" && entity.name != "SEQEND") {
      left_out.insert(std::string(entity.name));
    }
  }
  if (table.lines.empty())
    table.problems.push_back(
        {"", "the drawing has no 3DFACE and no 3-D POLYLINE", "export the joints as faces or closed 3-D polylines"});
  table.notes.push_back("a plane is fitted to the corners of each face; sets are the layers");
  if (scale != 1) table.notes.push_back("lengths were made metres, as the drawing's unit says");
  for (const std::string& name : left_out) table.notes.push_back(name + " is left out");
  return table;
}

}  // namespace talus
