#include "widgets/setup/several_blocks.hpp"

#include <map>

#include "session/current_project.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

/// "3 of them", behind each word.
void addCounts(Section& section, const std::map<QString, int>& counts) {
  for (const auto& [word, count] : counts) section.addFact(word, numbers::whole(count));
}

}  // namespace

SeveralBlocks::SeveralBlocks(const BlockSystem& system, const Project& project, const std::vector<int>& blocks) {
  double volume = 0, mass = 0;
  std::size_t nodes = 0, tetrahedra = 0;
  std::map<QString, int> bodies, materials;
  QStringList names;
  for (const int index : blocks) {
    const Block& block = system.blocks.at(static_cast<std::size_t>(index));
    volume += block.volume;
    nodes += block.mesh.nodes.size();
    tetrahedra += block.mesh.tetrahedra.size();
    ++bodies[words::body(block.body)];
    names << text(block.name);
    const auto material = static_cast<std::size_t>(block.material);
    if (material >= project.materials.size()) continue;
    mass += block.volume * project.materials[material].density;
    ++materials[text(project.materials[material].name)];
  }
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  const auto add = [&](const QString& title, const QString& note = {}) {
    if (column->count() > 0) column->addWidget(makeLine(Qt::Horizontal));
    auto* section = new Section(title, note);
    column->addWidget(section);
    return section;
  };
  auto* together = add(tr("Together"));
  together->addFact(tr("Volume"), tr("%1 m³").arg(numbers::significant(volume, 5)));
  together->addFact(tr("Mass"), tr("%1 t").arg(numbers::significant(mass / 1e3)));
  together->addFact(tr("Nodes"), numbers::whole(nodes));
  together->addFact(tr("Tetrahedra"), numbers::whole(tetrahedra));
  addCounts(*add(tr("Bodies"), tr("blocks")), bodies);
  addCounts(*add(tr("Materials"), tr("blocks")), materials);
  add(tr("Blocks"))->addWide(makeWrappedLabel(names.join(QStringLiteral(", ")), "small"));
}

}  // namespace talus
