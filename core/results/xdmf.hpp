#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace talus {

/// results.xdmf (XDMF 2; ParaView's "XDMF Reader"): a collection in time over results.h5 beside it.
/// A frame is written over the closing tags and brings them anew, so a long run costs the same for each frame; the
/// file is well-formed whatever moment the program is killed at.
class XdmfIndex {
 public:
  /// Makes the file with no frame. `name` is the project's. Throws std::runtime_error with the path, as `add_frame`.
  XdmfIndex(std::filesystem::path file, const std::string& name, std::uint64_t nodes, std::uint64_t tetrahedra);
  ~XdmfIndex();
  XdmfIndex(const XdmfIndex&) = delete;
  XdmfIndex& operator=(const XdmfIndex&) = delete;

  void add_frame(double time);

 private:
  std::string grid(double time) const;
  void insert(const std::string& text);
  void move_closing_tags_to_next_page();
  void write(std::uint64_t at, const std::string& text);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t nodes_, tetrahedra_, frames_ = 0;
  std::uint64_t closing_tags_at_ = 0;
};

}  // namespace talus
