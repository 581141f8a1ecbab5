#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace talus {

/// results.xdmf: a collection in time over results.h5 beside it.
/// While the run goes on it takes the rows of each frame out of the tables of results.h5 (XDMF 2; ParaView's "XDMF
/// Reader"). A frame is written over the closing tags and brings them anew, so a long run costs the same for each
/// frame; the file is well-formed whatever moment the program is killed at. Once the run is over it has the whole
/// datasets of frames.h5, the rows of each frame: ParaView's Xdmf3 readers, its default, take no part of a dataset.
class XdmfIndex {
 public:
  /// Makes the file with no frame. `name` is the project's. Throws WriteError, as all others do.
  XdmfIndex(std::filesystem::path file, const std::string& name, std::uint64_t nodes, std::uint64_t tetrahedra);
  ~XdmfIndex();
  XdmfIndex(const XdmfIndex&) = delete;
  XdmfIndex& operator=(const XdmfIndex&) = delete;

  void add_frame(double time);
  /// The run is over: writes frames.h5, and the index anew.
  void finish();

 private:
  enum class Frames { rows_of_tables, whole };
  void write_whole_frames() const;
  std::string beginning() const;
  std::string grid(std::size_t frame, Frames as) const;
  void insert(const std::string& text);
  void move_closing_tags_to_next_page();
  void write(std::uint64_t at, const std::string& text);

  std::filesystem::path path_;
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t nodes_, tetrahedra_;
  std::vector<double> times_;  ///< s, of the frames
  std::uint64_t closing_tags_at_ = 0;
};

}  // namespace talus
