#include "session/solid_surfaces.hpp"

#include <algorithm>
#include <filesystem>

#include "geometry/solid_surface.hpp"
#include "model/solid_shape.hpp"
#include "render/scene/thinned_surface.hpp"
#include "session/current_project.hpp"

namespace talus {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_triangles = 6000;  // of a solid that joints are drawn in, over each other
constexpr int quiet_ms = 150;                 // a pause in typing, and no wait that is noticed

/// The numbers of a solid and of all that it is made of, ascending.
std::vector<int> withParts(const Project& project, int solid) {
  std::vector<int> members{solid};
  if (const auto* combined = std::get_if<CombinedShape>(&project.solids[static_cast<std::size_t>(solid)].shape))
    for (int i = 0; i < solid; ++i)  // parts stand before what is made of them
      if (std::ranges::count(combined->solids, project.solids[static_cast<std::size_t>(i)].name) > 0)
        std::ranges::copy(withParts(project, i), std::back_inserter(members));
  std::ranges::sort(members);
  return members;
}

/// A solid is a part of another one, and no body of its own.
bool isPart(const Project& project, const std::string& name) {
  return std::ranges::any_of(project.solids, [&](const Solid& other) {
    const auto* combined = std::get_if<CombinedShape>(&other.shape);
    return combined && std::ranges::count(combined->solids, name) > 0;
  });
}

/// An error of a project that has some of the solids only, at the place that it has among all of them.
InputError amongAll(const InputError& error, const std::vector<int>& members) {
  const std::string lists = "/solids/";
  std::string place = lists + std::to_string(members.back());
  if (error.place().starts_with(lists)) {
    const auto end = std::min(error.place().find('/', lists.size()), error.place().size());
    const auto number = static_cast<std::size_t>(std::stoul(error.place().substr(lists.size(), end - lists.size())));
    if (number < members.size()) place = lists + std::to_string(members[number]) + error.place().substr(end);
  }
  return {place, error.problem(), error.remedy()};
}

std::shared_ptr<const SurfaceTree> treeOf(const SolidSurface& surface) {
  const auto few = thinned({surface.vertices, surface.triangles}, most_triangles);
  return std::make_shared<const SurfaceTree>(RockSurface{surface.vertices, few});
}

}  // namespace

Block surfaceBlock(const SolidSurface& surface, int solid, BodyKind body) {
  Block block;
  block.name = surface.name;
  block.solid = solid;
  block.body = body;
  block.mesh.nodes = surface.vertices;
  block.volume = surface.volume;
  for (const auto& corners : surface.triangles) block.surface.push_back({corners});
  return block;
}

std::vector<MarkedPlace> oddPlaces(const SolidSurface& surface) {
  std::vector<MarkedPlace> places;
  for (const SurfaceFinding& finding : surface.findings)
    if (!finding.mended)
      places.push_back({.at = finding.where, .label = std::string(name_of(finding.kind, finding.count != 1))});
  return places;
}

/// A solid with what it is made of, and nothing else that its surface does not depend on.
struct SolidSurfaces::Piece {
  std::vector<int> members;  ///< numbers of the solids in the project; the last one is the solid itself
  BodyKind body = BodyKind::tetrahedra;
  Project alone;
  fs::path folder;
  std::vector<fs::file_time_type> written;  ///< when the files were, that it is read from
  bool operator==(const Piece&) const = default;

  Piece(const Project& project, int solid, fs::path where) : members(withParts(project, solid)), folder(where) {
    alone.origin = project.origin;
    for (const int member : members) {
      const Solid& one = project.solids[static_cast<std::size_t>(member)];
      Solid& bare = alone.solids.emplace_back();
      bare.name = one.name;
      bare.shape = one.shape;
      bare.turn = one.turn;
      bare.move = one.move;
      std::error_code missing;
      if (const std::string* file = file_of(one.shape)) written.push_back(fs::last_write_time(folder / *file, missing));
    }
    body = project.solids[static_cast<std::size_t>(solid)].body;
  }
  bool looksLike(const Piece& other) const {
    return alone == other.alone && folder == other.folder && written == other.written;
  }
};

struct SolidSurfaces::Outcome {
  struct Made {
    Piece of;
    std::optional<SolidSurface> surface;
    std::optional<InputError> problem;  ///< at its place in `of.alone`
    std::shared_ptr<const SurfaceTree> tree;
  };
  std::vector<Made> made;
  std::vector<SolidSurface> surfaces;
  std::vector<InputError> problems;
  std::shared_ptr<const BlockSystem> blocks;
  std::shared_ptr<const std::vector<JointedRock>> jointed = std::make_shared<std::vector<JointedRock>>();
};

SolidSurfaces::SolidSurfaces(CurrentProject& project)
    : project_(project), shown_(std::make_shared<Outcome>()), job_(quiet_ms) {
  connect(&project_, &CurrentProject::opened, this, [this] {
    proposal_.reset();
    asked_.clear();
    shown_ = std::make_shared<Outcome>();
    emit changed();
    look();
  });
  connect(&job_, &LatestJob::rested, this, &SolidSurfaces::changed);  // nothing is being read any more
  connect(&project_.document(), &Document::projectChanged, this, &SolidSurfaces::look);
  connect(&project_.document(), &Document::savedChanged, this, &SolidSurfaces::look);  // its folder may be another one
}

SolidSurfaces::~SolidSurfaces() = default;

const std::vector<SolidSurface>* SolidSurfaces::current() const {
  return shown_->surfaces.empty() ? nullptr : &shown_->surfaces;
}

std::optional<BoxShape> SolidSurfaces::extent() const {
  std::optional<BoxShape> extent;
  for (const SolidSurface& one : shown_->surfaces) {
    if (!extent) extent = BoxShape{one.min, one.max};
    extent->min = extent->min.cwiseMin(one.min);
    extent->max = extent->max.cwiseMax(one.max);
  }
  return extent;
}

std::shared_ptr<const BlockSystem> SolidSurfaces::asBlocks() const { return current() ? shown_->blocks : nullptr; }

std::shared_ptr<const std::vector<JointedRock>> SolidSurfaces::jointed() const { return shown_->jointed; }

const std::vector<InputError>& SolidSurfaces::problems() const { return shown_->problems; }

void SolidSurfaces::propose(std::optional<Project> proposal) {
  if (!proposal && !proposal_) return;
  proposal_ = std::move(proposal);
  look();
}

void SolidSurfaces::look() {
  const Project& project = proposal_ ? *proposal_ : project_.document().project();
  std::vector<Piece> wanted;
  for (std::size_t i = 0; i < project.solids.size(); ++i)
    if (!isPart(project, project.solids[i].name))
      wanted.emplace_back(project, static_cast<int>(i), project_.document().folder());
  if (wanted == asked_) return;
  asked_ = wanted;
  job_.begin([wanted = std::move(wanted), earlier = shown_](
                 Progress& progress) { return std::make_shared<const Outcome>(make(wanted, *earlier, progress)); },
             [this](const std::shared_ptr<const Outcome>& outcome) {
               shown_ = outcome;
               emit changed();
             });
}

SolidSurfaces::Outcome SolidSurfaces::make(const std::vector<Piece>& wanted, const Outcome& earlier,
                                           Progress& progress) {
  Outcome outcome;
  BlockSystem blocks;
  std::vector<JointedRock> jointed;
  for (const Piece& piece : wanted) {
    Outcome::Made one{piece, {}, {}, {}};
    const auto same = [&](const Outcome::Made& made) { return made.of.looksLike(piece); };
    if (const auto known = std::ranges::find_if(earlier.made, same); known != earlier.made.end()) {
      one.surface = known->surface;
      one.problem = known->problem;
      one.tree = known->tree;
    } else {
      try {
        one.surface = solid_surfaces(piece.alone, piece.folder, progress).back();  // parts come before
        one.tree = treeOf(*one.surface);
      } catch (const InputError& error) {
        one.problem = error;
      }
    }
    if (one.problem) outcome.problems.push_back(amongAll(*one.problem, piece.members));
    if (one.surface) {
      outcome.surfaces.push_back(*one.surface);
      blocks.blocks.push_back(surfaceBlock(*one.surface, piece.members.back(), piece.body));
      jointed.push_back({one.surface->name, one.tree});
    }
    outcome.made.push_back(std::move(one));
  }
  outcome.blocks = std::make_shared<const BlockSystem>(std::move(blocks));
  outcome.jointed = std::make_shared<const std::vector<JointedRock>>(std::move(jointed));
  return outcome;
}

}  // namespace talus
