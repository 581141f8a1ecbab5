#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "geometry/byte_stream.hpp"
#include "geometry/solid_surface.hpp"
#include "mesh/cutting_report.hpp"
#include "mesh/tet_mesh.hpp"
#include "model/project.hpp"

/// What passes between the program and the mesher, a program of its own: a job goes out, and what cutting will come to
/// and then what it made of it come back; how finely to mesh each block goes out, and blocks and at last an end come
/// back. Or a job goes out of which the solids are only looked at, and a SolidSurface of each and an end come back.
/// Progress comes between, and an error or a fault instead. Names are resolved to indices before.
namespace talus {

/// What progress begins with while a user's file is read.
inline constexpr std::string_view words_of_reading = "reading";

/// Where a solid lies: a point of its shape, less the origin of the files' coordinates, is turned and then moved.
struct MesherPlacement {
  Vec3 origin = Vec3::Zero();  ///< m
  Vec3 axis = Vec3::UnitZ(), about = Vec3::Zero();
  double angle = 0;  ///< rad
  Vec3 move = Vec3::Zero();

  template <class Stream>
  void fields(Stream& stream) {
    stream(origin, axis, about, angle, move);
  }
};

/// The solid's file has the surface that it lies below.
struct MesherTerrain {
  double base = 0, tolerance = 0;  ///< m

  template <class Stream>
  void fields(Stream& stream) {
    stream(base, tolerance);
  }
};

struct MesherCombination {
  CombineOperation operation = CombineOperation::unite;
  std::vector<int> solids;  ///< indices into MesherJob::solids, all before its own

  template <class Stream>
  void fields(Stream& stream) {
    stream(operation, solids);
  }
};

/// A polyhedron, a file or a combination.
struct MesherSolid {
  std::string name;
  PolyhedronShape polyhedron;  ///< placed already
  std::string file;            ///< absolute path
  std::string file_as_written;
  double scale = 1;  ///< m per unit of the file
  std::optional<MesherTerrain> terrain;
  std::optional<MesherCombination> combined;
  MesherPlacement placement;
  bool is_part = false;             ///< of a combined solid: no body of its own
  bool corners_suffice = false;     ///< for all of its blocks, which planes without end cut
  std::optional<double> mesh_size;  ///< m

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, polyhedron.vertices, polyhedron.faces, file, file_as_written, scale, terrain, combined, placement,
           is_part, corners_suffice, mesh_size);
  }
};

/// A joint of a cut that has others than parallel planes without end.
struct MesherJoint {
  double dip = 0, dip_direction = 0;  ///< degrees
  Vec3 through = Vec3::Zero();
  std::vector<Vec3> outline;  ///< corners in order, where it ends; empty: without end

  template <class Stream>
  void fields(Stream& stream) {
    stream(dip, dip_direction, through, outline);
  }
};

/// `count` planes, `spacing` apart along the upward normal; or `joints`, where there are any.
struct MesherCut {
  std::string title;  ///< "cut 3 (J2)"
  int joint = 0;
  double dip = 0, dip_direction = 0;  ///< degrees
  Vec3 through = Vec3::Zero();
  double spacing = 0;  ///< m
  int count = 1;
  std::vector<MesherJoint> joints;
  std::vector<int> solids;
  std::vector<int> ends_at;  ///< joints at whose cuts it ends, as indices into Project::joints
  bool may_miss = false;     ///< a network is where chance puts it

  template <class Stream>
  void fields(Stream& stream) {
    stream(title, joint, dip, dip_direction, through, spacing, count, joints, solids, ends_at, may_miss);
  }
};

struct MesherOverride {
  std::string name;
  Vec3 at = Vec3::Zero();
  std::optional<double> mesh_size;
  bool removed = false;

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, at, mesh_size, removed);
  }
};

struct MesherMerge {
  Vec3 at = Vec3::Zero(), with = Vec3::Zero();

  template <class Stream>
  void fields(Stream& stream) {
    stream(at, with);
  }
};

struct MesherRefinement : MeshRefinement {
  template <class Stream>
  void fields(Stream& stream) {
    stream(at, radius, size, face);
  }
};

struct MesherJob {
  std::vector<MesherSolid> solids;
  std::vector<MesherCut> cuts;
  std::vector<MesherOverride> overrides;
  std::vector<MesherMerge> merges;
  std::optional<double> splinter_thickness;  ///< m; 1e-4 of the mesh size when absent
  double chip_volume = 0;                    ///< over the median of a solid's blocks
  SplinterRule splinter_rule = SplinterRule::drop;
  std::vector<MesherRefinement> refinements;

  template <class Stream>
  void fields(Stream& stream) {
    stream(solids, cuts, overrides, merges, splinter_thickness, chip_volume, splinter_rule, refinements);
  }
};

struct MesherSplinter : Splinter {
  template <class Stream>
  void fields(Stream& stream) {
    stream(solid, where, volume, thickness, fate, merged_into);
  }
};

/// What cutting will come to, before it is done.
struct MesherCutAhead {
  double blocks = 0;
  double seconds = 0;
  double bytes = 0;  ///< that the mesher holds of it

  template <class Stream>
  void fields(Stream& stream) {
    stream(blocks, seconds, bytes);
  }
};

/// A block that is cut and named but not meshed yet.
struct MesherCutBlock {
  std::string name;
  int solid = 0;
  int block_override = -1;   ///< index into MesherJob::overrides; −1: none
  double usual_size = 0;     ///< m, of its mesh: as given, or a tenth of its solid's longest side
  double coarsest_size = 0;  ///< m, at which its corners alone carry the mesh; the usual one where faces are curved
  bool of_cells = false;     ///< its solid is triangles: it needs no mesh inside unless it deforms
  double volume = 0;         ///< m³
  double area = 0;           ///< m², of its surface
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();  ///< m, corners of the box around it
  int corners = 0;                              ///< points that every mesh of it has

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, solid, block_override, usual_size, coarsest_size, of_cells, volume, area, min, max, corners);
  }
};

struct MesherEndings : EndingJoints {
  template <class Stream>
  void fields(Stream& stream) {
    stream(cut, joints, dividing);
  }
};

struct MesherCutModel {
  Vec3 extent = Vec3::Zero();   ///< m, of the box around all solids
  double solids_volume = 0;     ///< m³, before cutting
  double excavated_volume = 0;  ///< m³, of blocks that are left out as the project wants
  std::vector<MesherCutBlock> blocks;
  std::vector<MesherSplinter> splinters;  ///< left out, or parts of other blocks
  std::vector<MesherEndings> endings;     ///< of cuts whose joints end

  template <class Stream>
  void fields(Stream& stream) {
    stream(extent, solids_volume, excavated_volume, blocks, splinters, endings);
  }
};

/// How finely a block is meshed.
struct MesherSize {
  double size = 0;       ///< m
  bool refined = false;  ///< by the job's refinements, too

  template <class Stream>
  void fields(Stream& stream) {
    stream(size, refined);
  }
};

struct MesherSizes {
  std::vector<MesherSize> sizes;     ///< a block, in the order of MesherCutModel::blocks
  std::vector<std::uint64_t> known;  ///< keys of meshes that need not be made again

  template <class Stream>
  void fields(Stream& stream) {
    stream(sizes, known);
  }
};

/// In the order of MesherCutModel::blocks, one by one.
struct MesherBlock {
  std::uint64_t key = 0;  ///< of all that the mesh is made of; 0: of corners alone, nothing is saved by keeping it
  bool is_known = false;  ///< it is one of those that were said to be known; nothing but the key is sent
  double volume = 0;      ///< m³, of the shape before meshing
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> triangle_joints;

  template <class Stream>
  void fields(Stream& stream) {
    stream(key, is_known, volume, nodes, tetrahedra, triangles, triangle_joints);
  }
};

struct MesherProgress {
  double fraction = 0;
  std::string what;

  template <class Stream>
  void fields(Stream& stream) {
    stream(fraction, what);
  }
};

/// All that was wanted is done.
struct MesherEnd {
  template <class Stream>
  void fields(Stream&) {}
};

/// An InputError on its way; one that finds splinters tells where they are.
struct MesherError {
  std::string place, problem, remedy;
  std::vector<MesherSplinter> splinters;

  template <class Stream>
  void fields(Stream& stream) {
    stream(place, problem, remedy, splinters);
  }
};

/// Our own mistake on its way.
struct MesherFault {
  std::string what;

  template <class Stream>
  void fields(Stream& stream) {
    stream(what);
  }
};

enum class MessageKind : std::uint64_t { job, ahead, cut, sizes, look, surface, progress, block, end, error, fault };

/// Of all messages, and the version of Talus: a program and a mesher of different builds may have different ones, and
/// cannot understand each other; those of different versions would not make the same of a job.
std::uint64_t layout_of_messages(std::string_view version);

/// Precedes every message.
struct MessageHeader {
  std::uint64_t layout = 0;  ///< first, whatever may be changed behind it
  MessageKind kind = MessageKind::job;
  std::uint64_t size = 0;  ///< bytes that follow
};
static_assert(std::has_unique_object_representations_v<MessageHeader>, "all of its bytes are sent");

/// Of a message of this version.
MessageHeader header_of(MessageKind kind, const std::string& bytes);
/// Whether the message that it precedes is of this version.
bool is_understood(const MessageHeader& header);

template <class T>
std::string to_bytes(T value) {
  ByteWriter writer;
  value.fields(writer);
  return writer.bytes();
}

template <class T>
T from_bytes(std::string_view bytes) {
  ByteReader reader(bytes);
  T value;
  value.fields(reader);
  return value;
}

}  // namespace talus
