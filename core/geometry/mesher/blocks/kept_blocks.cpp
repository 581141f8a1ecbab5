#include "geometry/mesher/blocks/kept_blocks.hpp"

#include <map>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "geometry/mesher/blocks/piece_at.hpp"
#include "geometry/mesher/blocks/splinters.hpp"
#include "geometry/mesher/solid_size.hpp"

namespace talus {
namespace {

std::string title_of(const MesherJob& job, int index) {
  const MesherOverride& wanted = job.overrides[static_cast<std::size_t>(index)];
  return "block override " + std::to_string(index + 1) + (wanted.name.empty() ? "" : " (" + wanted.name + ")");
}

std::vector<std::string> names_of_pieces(const MesherJob& job, const CutModel& cut) {
  std::vector<int> pieces(job.solids.size(), 0), next(job.solids.size(), 0);
  for (const CutBlock& block : cut.blocks) ++pieces[static_cast<std::size_t>(block.solid)];
  std::vector<std::string> names;
  for (const CutBlock& block : cut.blocks) {
    const auto s = static_cast<std::size_t>(block.solid);
    const std::string& solid = job.solids[s].name;
    names.push_back(pieces[s] == 1 ? solid : solid + "." + std::to_string(++next[s]));
  }
  return names;
}

/// Pieces, and which of them are one block: that of the piece that was first in their merges.
class Pieces {
 public:
  Pieces(const MesherJob& job, const ImportedModel& model, const CutModel& cut)
      : job_(job), model_(model), cut_(cut), names_(names_of_pieces(job, cut)), owner_(cut.blocks.size()) {
    std::iota(owner_.begin(), owner_.end(), std::size_t{0});
    blocks_.assign(cut.blocks.begin(), cut.blocks.end());
  }

  void merge();
  std::vector<NamedBlock> named() const;

 private:
  std::size_t piece(std::string title, const char* key, const Vec3& at) const {
    return piece_at({std::move(title), key, at - model_.origin}, cut_, names_);
  }
  void merge(std::size_t index);
  std::vector<int> overrides_of_pieces() const;
  std::vector<int> overrides_of_blocks() const;

  const MesherJob& job_;
  const ImportedModel& model_;
  const CutModel& cut_;
  std::vector<std::string> names_;
  std::vector<std::size_t> owner_;               ///< of each piece
  std::vector<std::optional<CutBlock>> blocks_;  ///< by the piece that owns it
};

void Pieces::merge() {
  for (std::size_t i = 0; i < job_.merges.size(); ++i) merge(i);
}

void Pieces::merge(std::size_t index) {
  const MesherMerge& merge = job_.merges[index];
  const std::string title = "merge " + std::to_string(index + 1);
  const std::size_t first = owner_[piece(title, "at", merge.at)], second = owner_[piece(title, "with", merge.with)];
  if (first == second) return;
  const std::string at_both = names_[first] + ", at " + coordinates(merge.at) + ", and " + names_[second] + ", at " +
                              coordinates(merge.with) + ",";
  if (blocks_[first]->solid != blocks_[second]->solid) {
    throw InputError(title, "its blocks " + at_both + " belong to different solids",
                     "unite the solids with \"combine\", and cut that");
  }
  if (!(shared_area(*blocks_[first], *blocks_[second]) > 0)) {
    throw InputError(title, "its blocks " + at_both + " share no face",
                     "merge blocks that lie against each other, one after the other");
  }
  join(*blocks_[first], *blocks_[second]);
  blocks_[second].reset();
  for (std::size_t& owner : owner_)
    if (owner == second) owner = first;
}

/// Index of the override in each piece, −1 where there is none.
std::vector<int> Pieces::overrides_of_pieces() const {
  std::vector<int> found(owner_.size(), -1);
  for (std::size_t i = 0; i < job_.overrides.size(); ++i) {
    const int index = static_cast<int>(i);
    int& known = found[piece(title_of(job_, index), "at", job_.overrides[i].at)];
    if (known >= 0) {
      throw InputError(title_of(job_, index), "lies in the same block as " + title_of(job_, known), "keep one of them");
    }
    known = index;
  }
  return found;
}

/// Of each block, at the piece that owns it. What is said of a piece that was merged counts where nothing is said of
/// the first.
std::vector<int> Pieces::overrides_of_blocks() const {
  std::vector<int> found = overrides_of_pieces();
  for (std::size_t piece = 0; piece < owner_.size(); ++piece) {
    const std::size_t owner = owner_[piece];
    const int index = found[piece];
    if (owner == piece || index < 0) continue;
    if (found[owner] < 0) {
      found[owner] = index;
    } else if (job_.overrides[static_cast<std::size_t>(index)].removed) {
      throw InputError(title_of(job_, index), "is removed and merged with " + title_of(job_, found[owner]),
                       "do one of the two");
    }
  }
  return found;
}

std::vector<NamedBlock> Pieces::named() const {
  const std::vector<int> overrides = overrides_of_blocks();
  std::vector<NamedBlock> named;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (!blocks_[i]) continue;
    const auto solid = static_cast<std::size_t>(blocks_[i]->solid);
    NamedBlock block{*blocks_[i], names_[i], overrides[i], mesh_size_of(job_.solids[solid], model_.solids[solid])};
    if (block.block_override >= 0) {
      const MesherOverride& wanted = job_.overrides[static_cast<std::size_t>(block.block_override)];
      if (!wanted.name.empty()) block.name = wanted.name;
      if (wanted.mesh_size) block.mesh_size = *wanted.mesh_size;
    }
    named.push_back(std::move(block));
  }
  return named;
}

/// m³, of those that are left out.
double leave_out_removed(std::vector<NamedBlock>& blocks, const MesherJob& job) {
  double volume = 0;
  std::erase_if(blocks, [&](const NamedBlock& block) {
    const bool removed =
        block.block_override >= 0 && job.overrides[static_cast<std::size_t>(block.block_override)].removed;
    if (removed) volume += block.shape.volume;
    return removed;
  });
  return volume;
}

void check_names_differ(const std::vector<NamedBlock>& blocks) {
  std::map<std::string, int> count;
  for (const NamedBlock& block : blocks) {
    if (++count[block.name] > 1) {
      throw InputError("block " + block.name, "two blocks have this name", "give one of them another name");
    }
  }
}

}  // namespace

KeptBlocks keep_blocks(const MesherJob& job, const ImportedModel& model, const CutModel& cut) {
  Pieces pieces(job, model, cut);
  pieces.merge();
  KeptBlocks kept;
  kept.blocks = pieces.named();
  kept.excavated_volume = leave_out_removed(kept.blocks, job);
  kept.splinters = treat_splinters(kept.blocks, job, model);
  check_names_differ(kept.blocks);
  if (kept.blocks.empty()) throw InputError("/blocks", "no block is left", "remove fewer of them");
  return kept;
}

}  // namespace talus
