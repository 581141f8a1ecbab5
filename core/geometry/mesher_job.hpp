#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/byte_stream.hpp"
#include "mesh/tet_mesh.hpp"
#include "model/project.hpp"

/// What passes between the program and the mesher, a program of its own: a job goes out, progress, blocks and at last
/// an end or an error come back. Names are resolved to indices before.
namespace talus {

struct MesherSolid {
  std::string name;
  PolyhedronShape polyhedron;  ///< empty when `file` is given
  std::string file;            ///< absolute path
  std::string file_as_written;
  double scale = 1;
  std::optional<double> mesh_size;  ///< m

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, polyhedron.vertices, polyhedron.faces, file, file_as_written, scale, mesh_size);
  }
};

/// `count` planes, `spacing` apart along the upward normal.
struct MesherCut {
  std::string title;  ///< "cut 3 (J2)"
  int joint = 0;
  double dip = 0, dip_direction = 0;  ///< degrees
  Vec3 through = Vec3::Zero();
  double spacing = 0;  ///< m
  int count = 1;
  std::vector<int> solids;

  template <class Stream>
  void fields(Stream& stream) {
    stream(title, joint, dip, dip_direction, through, spacing, count, solids);
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

struct MesherBlock {
  std::string name;
  int solid = 0;
  int block_override = -1;  ///< index into MesherJob::overrides; −1: none
  double volume = 0;        ///< m³, of the shape before meshing
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> triangle_joints;

  template <class Stream>
  void fields(Stream& stream) {
    stream(name, solid, block_override, volume, nodes, tetrahedra, triangles, triangle_joints);
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

enum class MessageKind : std::uint32_t { job, progress, block, end, error, fault };

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
