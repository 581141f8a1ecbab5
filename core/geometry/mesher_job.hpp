#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/byte_stream.hpp"
#include "mesh/tet_mesh.hpp"
#include "model/project.hpp"

/// What passes between the program and the mesher, a program of its own: a job goes out, and what cutting made of it
/// comes back; how finely to mesh each block goes out, and blocks and at last an end come back. Or a job goes out of
/// which the solids are only looked at, and a SolidSurface of each and an end come back. Progress comes between, and an
/// error or a fault instead. Names are resolved to indices before.
namespace talus {

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
  std::optional<double> mesh_size;  ///< m

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, polyhedron.vertices, polyhedron.faces, file, file_as_written, scale, terrain, combined, placement,
           is_part, mesh_size);
  }
};

/// A plane that a set of joints has by chance.
struct MesherPlane {
  double dip = 0, dip_direction = 0;  ///< degrees
  Vec3 through = Vec3::Zero();

  template <class Stream>
  void fields(Stream& stream) {
    stream(dip, dip_direction, through);
  }
};

/// `count` planes, `spacing` apart along the upward normal; or those that were drawn, where there are any.
struct MesherCut {
  std::string title;  ///< "cut 3 (J2)"
  int joint = 0;
  double dip = 0, dip_direction = 0;  ///< degrees
  Vec3 through = Vec3::Zero();
  double spacing = 0;  ///< m
  int count = 1;
  std::vector<MesherPlane> drawn;
  std::vector<int> solids;

  template <class Stream>
  void fields(Stream& stream) {
    stream(title, joint, dip, dip_direction, through, spacing, count, drawn, solids);
  }
};

struct MesherOverride {
  std::string name;
  Vec3 at = Vec3::Zero();
  std::optional<double> mesh_size;

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, at, mesh_size);
  }
};

struct MesherJob {
  std::vector<MesherSolid> solids;
  std::vector<MesherCut> cuts;
  std::vector<MesherOverride> overrides;

  template <class Stream>
  void fields(Stream& stream) {
    stream(solids, cuts, overrides);
  }
};

/// A block that is cut and named but not meshed yet.
struct MesherCutBlock {
  std::string name;
  int solid = 0;
  int block_override = -1;   ///< index into MesherJob::overrides; −1: none
  double usual_size = 0;     ///< m, of its mesh: as given, or a tenth of its solid's longest side
  double coarsest_size = 0;  ///< m, at which its corners alone carry the mesh; the usual one where faces are curved

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, solid, block_override, usual_size, coarsest_size);
  }
};

struct MesherCutModel {
  Vec3 extent = Vec3::Zero();  ///< m, of the box around all solids
  std::vector<MesherCutBlock> blocks;

  template <class Stream>
  void fields(Stream& stream) {
    stream(extent, blocks);
  }
};

struct MesherSizes {
  std::vector<double> sizes;  ///< m, a block, in the order of MesherCutModel::blocks

  template <class Stream>
  void fields(Stream& stream) {
    stream(sizes);
  }
};

/// In the order of MesherCutModel::blocks, one by one.
struct MesherBlock {
  double volume = 0;  ///< m³, of the shape before meshing
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> triangle_joints;

  template <class Stream>
  void fields(Stream& stream) {
    stream(volume, nodes, tetrahedra, triangles, triangle_joints);
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

struct MesherEnd {
  double solids_volume = 0;  ///< m³, before cutting

  template <class Stream>
  void fields(Stream& stream) {
    stream(solids_volume);
  }
};

/// An InputError on its way.
struct MesherError {
  std::string place, problem, remedy;

  template <class Stream>
  void fields(Stream& stream) {
    stream(place, problem, remedy);
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

enum class MessageKind : std::uint32_t { job, cut, sizes, look, surface, progress, block, end, error, fault };

/// Precedes every message.
struct MessageHeader {
  MessageKind kind = MessageKind::job;
  std::uint64_t size = 0;  ///< bytes that follow
};

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
