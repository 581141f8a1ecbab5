#include "measures/slipped_faces.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "measures/node_places.hpp"
#include "mesh/block_faces.hpp"

namespace talus {

namespace {

/// A contact lies on a face whose normal, gone along with its block, is as near as this to the contact's.
const double same_face = std::cos(radians(10));

}  // namespace

SlipWatch::SlipWatch(const BlockSystem& system) : system_(system), fit_(system), first_(first_nodes(system)) {
  const BlockFaces found = block_faces(system);
  for (const SharedFace& shared : found.shared) {
    const FlatFace &one = found.faces[static_cast<std::size_t>(shared.face)],
                   &other = found.faces[static_cast<std::size_t>(shared.other)];
    const std::array<int, 2> blocks{one.block, other.block};  // ascending, as faces go block by block
    waiting_[blocks].push_back({blocks, one.joint, one.normal, shared.area, 0});
  }
}

void SlipWatch::take(const Frame& frame) {
  for (const ContactSample& contact : frame.contacts) {
    if (contact.state != ContactState::slip) continue;
    const auto pair =
        waiting_.find({std::min(contact.blocks[0], contact.blocks[1]), std::max(contact.blocks[0], contact.blocks[1])});
    if (pair == waiting_.end()) continue;
    const auto b = static_cast<std::size_t>(pair->first[0]);
    const Block& block = system_.blocks[b];
    const std::vector<Vec3> moved = places(block, first_[b], frame);
    const Mat3 turn = fit_.pose(pair->first[0], block.mesh.nodes.data(), moved.data()).rotation;
    std::vector<SlippedFace>& faces = pair->second;
    const auto found = std::ranges::find_if(
        faces, [&](const SlippedFace& face) { return std::abs((turn * face.normal).dot(contact.normal)) > same_face; });
    if (found == faces.end()) continue;
    found->joint = contact.joint;
    found->since = frame.time;
    slipped_.push_back(*found);
    faces.erase(found);
    if (faces.empty()) waiting_.erase(pair);
  }
}

std::vector<SlippedFace> slipped_faces(const ResultReader& results, Progress& progress) {
  SlipWatch watch(results.system());
  const std::size_t count = results.frame_times().size();
  for (std::size_t number = 0; number < count; ++number) {
    if (progress.cancelled()) throw Cancelled{};
    progress.report(static_cast<double>(number) / static_cast<double>(count),
                    "frame " + std::to_string(number + 1) + " of " + std::to_string(count));
    watch.take(results.frame(static_cast<int>(number)));
  }
  return watch.slipped();
}

}  // namespace talus
