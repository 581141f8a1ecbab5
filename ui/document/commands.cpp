#include "document/commands.hpp"

namespace talus {

ChangeMaterial::ChangeMaterial(Document& document, int index, Material changed)
    : document_(document),
      index_(index),
      before_(document.project().materials.at(static_cast<size_t>(index))),
      after_(std::move(changed)) {
  setText(QObject::tr("change material %1").arg(QString::fromStdString(before_.name)));
}

void ChangeMaterial::apply(const Material& value) {
  document_.project_.materials[static_cast<size_t>(index_)] = value;
  emit document_.projectChanged();
}

ChangeJoint::ChangeJoint(Document& document, int index, Joint changed)
    : document_(document),
      index_(index),
      before_(document.project().joints.at(static_cast<size_t>(index))),
      after_(std::move(changed)) {
  setText(QObject::tr("change joint %1").arg(QString::fromStdString(before_.name)));
}

void ChangeJoint::apply(const Joint& value) {
  document_.project_.joints[static_cast<size_t>(index_)] = value;
  emit document_.projectChanged();
}

ChangeSolid::ChangeSolid(Document& document, int index, Solid changed)
    : document_(document),
      index_(index),
      before_(document.project().solids.at(static_cast<size_t>(index))),
      after_(std::move(changed)) {
  setText(QObject::tr("change solid %1").arg(QString::fromStdString(before_.name)));
}

void ChangeSolid::apply(const Solid& value) {
  document_.project_.solids[static_cast<size_t>(index_)] = value;
  emit document_.projectChanged();
}

ChangeProject::ChangeProject(Document& document, Project changed, const QString& what)
    : document_(document), before_(document.project()), after_(std::move(changed)) {
  setText(what);
}

void ChangeProject::apply(const Project& value) {
  document_.project_ = value;
  emit document_.projectChanged();
}

}  // namespace talus
