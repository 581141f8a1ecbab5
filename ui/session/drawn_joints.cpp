#include "session/drawn_joints.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/error.hpp"
#include "session/current_project.hpp"
#include "session/solid_surfaces.hpp"

namespace talus {

namespace {

constexpr int network_pause_ms = 50;  // before a network is drawn: a hand that moves it goes on

/// Colours go by the order in which sets first appear, as on the stereonet.
std::vector<int> setsOf(const std::vector<Cut>& cuts) {
  std::vector<std::string> names;
  std::vector<int> sets;
  for (const Cut& cut : cuts) {
    const auto found = std::ranges::find(names, cut.joint);
    sets.push_back(static_cast<int>(found - names.begin()));
    if (found == names.end()) names.push_back(cut.joint);
  }
  return sets;
}

}  // namespace

DrawnJoints::DrawnJoints(CurrentProject& project, SolidSurfaces& surfaces)
    : project_(project), surfaces_(surfaces), faces_(std::make_shared<Faces>()), networks_(network_pause_ms) {
  connect(&project_, &CurrentProject::opened, this, &DrawnJoints::follow);
  connect(&project_.document(), &Document::projectChanged, this, &DrawnJoints::follow);
  connect(&surfaces_, &SolidSurfaces::changed, this, &DrawnJoints::changed);
}

DrawnJoints::~DrawnJoints() = default;

void DrawnJoints::follow() {
  trial_.reset();
  emit changed();
}

std::vector<Cut> DrawnJoints::cuts() const {
  std::vector<Cut> cuts = project_.document().project().cuts;
  if (trial_ && trial_->cut < static_cast<int>(cuts.size())) cuts[static_cast<std::size_t>(trial_->cut)] = trial_->as;
  return cuts;
}

std::vector<int> DrawnJoints::selectedCuts() {
  const Project& project = project_.document().project();
  const Item& current = project_.selection().current();
  if (current.kind == Item::Kind::cut) return {current.index};
  std::vector<int> chosen;
  const bool isJoint = current.kind == Item::Kind::joint && current.index >= 0 &&
                       current.index < static_cast<int>(project.joints.size());
  for (std::size_t i = 0; isJoint && i < project.cuts.size(); ++i)
    if (project.cuts[i].joint == project.joints[static_cast<std::size_t>(current.index)].name)
      chosen.push_back(static_cast<int>(i));
  return chosen;
}

void DrawnJoints::tryOut(int cut, const Cut& as) {
  trial_ = Trial{cut, as};
  emit changed();
}

void DrawnJoints::endTrial() {
  if (!trial_) return;
  trial_.reset();
  emit changed();
}

/// What each cut is drawn from.
std::vector<DrawnJoints::Source> DrawnJoints::sources() const {
  const std::vector<Cut> all = cuts();
  std::vector<Source> sources;
  for (const Cut& cut : all) {
    Source& source = sources.emplace_back(Source{cut, {}, surfaces_.jointed()});
    for (const Cut& other : all)
      if (std::ranges::count(cut.ends_at, other.joint) > 0) source.ends.push_back(other);
  }
  return sources;
}

std::shared_ptr<const DrawnJoints::Faces> DrawnJoints::faces() {
  std::vector<Source> wanted = sources();
  if (wanted == made_) return faces_;
  auto faces = std::make_shared<Faces>(*faces_);
  faces->resize(wanted.size());
  made_.resize(wanted.size());
  late_.resize(wanted.size(), false);
  const std::vector<int> sets = setsOf(cuts());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    JointFace& face = (*faces)[i];
    if (made_[i] != wanted[i]) {
      late_[i] = wanted[i].cut.network.has_value();
      if (!late_[i]) face = wanted[i].face();
    }
    face.cut = static_cast<int>(i);
    face.set = sets[i];
  }
  made_ = std::move(wanted);
  faces_ = std::move(faces);
  if (std::ranges::count(late_, true) > 0) drawNetworks();
  return faces_;
}

/// They have hundreds of discs: those before are in view until all are made.
void DrawnJoints::drawNetworks() {
  using Made = std::vector<std::pair<Source, JointFace>>;
  std::vector<Source> wanted;
  for (std::size_t i = 0; i < made_.size(); ++i)
    if (late_[i]) wanted.push_back(made_[i]);
  networks_.begin(
      [wanted = std::move(wanted)](Progress& progress) {
        Made made;
        for (const Source& source : wanted) {
          if (progress.cancelled()) throw Cancelled();
          made.emplace_back(source, source.face());
        }
        return std::make_shared<const Made>(std::move(made));
      },
      [this](const std::shared_ptr<const Made>& made) {
        auto faces = std::make_shared<Faces>(*faces_);
        for (const auto& [source, face] : *made)
          for (std::size_t i = 0; i < made_.size(); ++i) {
            if (made_[i] != source) continue;
            (*faces)[i].triangles = face.triangles;
            (*faces)[i].outline = face.outline;
            late_[i] = false;
          }
        faces_ = std::move(faces);
        emit changed();
      });
}

JointFace DrawnJoints::Source::face() const { return drawn_joint(cut, ends, *rock); }

std::optional<Vec3> DrawnJoints::middleOf(int cut) {
  double area = 0;
  Vec3 moment = Vec3::Zero();
  for (const FlatTriangle& triangle : faces()->at(static_cast<std::size_t>(cut)).triangles) {
    const double one = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm();
    area += one;
    moment += one * (triangle[0] + triangle[1] + triangle[2]) / 3;
  }
  return area > 0 ? std::optional<Vec3>(moment / area) : std::nullopt;
}

}  // namespace talus
