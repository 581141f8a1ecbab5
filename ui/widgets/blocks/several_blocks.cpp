#include "widgets/blocks/several_blocks.hpp"

#include <QComboBox>
#include <QLineEdit>
#include <array>
#include <map>
#include <set>

#include "base/error.hpp"
#include "session/block_survey.hpp"
#include "session/messages.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr int most_names = 40;  // that are written out; the table has all

/// "3 of them", behind each word.
void addCounts(Section& section, const std::map<QString, int>& counts) {
  for (const auto& [word, count] : counts) section.addFact(word, numbers::whole(count));
}

/// A box whose first entry takes what was given away again; it shows the value that all have in common.
QComboBox* makeChoice(const QString& title, const QStringList& choices, const std::set<QString>& now) {
  auto* box = makeCombo(QStringList{QObject::tr("as their solids")} + choices, title);
  box->setCurrentIndex(now.size() == 1 ? 1 + static_cast<int>(choices.indexOf(*now.begin())) : -1);
  box->setPlaceholderText(QObject::tr("different ones"));
  return box;
}

}  // namespace

SeveralBlocks::SeveralBlocks(CurrentProject& project, const BlockSurvey& survey, Messages& messages,
                             std::vector<int> blocks)
    : project_(project),
      survey_(survey),
      messages_(messages),
      blocks_(std::move(blocks)),
      said_(block_edits::said(project_, blocks_)) {
  setMargins(new QVBoxLayout(this), 0, 0);
  addEdits(*add(tr("For all of them")));
  addFacts();
}

Section* SeveralBlocks::add(const QString& title, const QString& note) {
  auto* column = static_cast<QVBoxLayout*>(layout());
  if (column->count() > 0) column->addWidget(makeLine(Qt::Horizontal));
  auto* section = new Section(title, note);
  column->addWidget(section);
  return section;
}

void SeveralBlocks::tryTo(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    messages_.add(problemOf(error));
  }
}

void SeveralBlocks::addEdits(Section& section) {
  addName(section);
  addBody(section);
  addMaterial(section);
  addMeshSize(section);
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  setMargins(row, 0, 6);
  const auto addButton = [&](const QString& words, const QString& name, const QString& tip, auto act) {
    auto* button = makeButton(words);
    button->setObjectName(name);
    button->setToolTip(tip);
    // The panel is made anew by what the button does.
    connect(
        button, &QPushButton::clicked, this, [this, act] { tryTo(act); }, Qt::QueuedConnection);
    row->addWidget(button);
  };
  addButton(tr("Excavate"), QStringLiteral("excavate"), tr("Leaves them out: they are cut and taken away"),
            [this] { block_edits::excavate(project_, blocks_); });
  addButton(tr("Merge"), QStringLiteral("merge"), tr("Makes them one block; they must lie against each other"), [this] {
    if (!survey_.facts())
      throw InputError(tr("blocks").toStdString(), tr("their neighbours are not known yet").toStdString(),
                       tr("try again in a moment").toStdString());
    block_edits::merge(project_, blocks_, *survey_.facts());
  });
  row->addStretch();
  section.addWide(buttons);
}

void SeveralBlocks::addName(Section& section) {
  auto* name = new QLineEdit;
  name->setObjectName(QStringLiteral("names"));
  name->setPlaceholderText(QStringLiteral("roof {n}"));
  name->setAccessibleName(tr("Names"));
  connect(name, &QLineEdit::returnPressed, this,
          [this, name] { tryTo([&] { block_edits::rename(project_, blocks_, name->text()); }); });
  section.addRow(tr("Names"), name, tr("{n} becomes 1, 2, … in the order of the blocks; Enter gives the names"));
}

void SeveralBlocks::addBody(Section& section) {
  constexpr std::array bodies{BodyKind::fixed, BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra,
                              BodyKind::automatic};
  QStringList titles;
  for (const BodyKind body : bodies) titles << words::body(body);
  std::set<QString> now;
  for (const BlockOverride& one : said_) now.insert(words::body(*one.body));
  auto* box = makeChoice(tr("Body"), titles, now);
  box->setObjectName(QStringLiteral("body"));
  connect(box, &QComboBox::activated, this, [this, bodies](int index) {
    tryTo([&] {
      block_edits::setBody(project_, blocks_,
                           index > 0 ? std::optional(bodies[static_cast<std::size_t>(index - 1)]) : std::nullopt);
    });
  });
  section.addRow(tr("Body"), box, tr("What the blocks may do: nothing, move, deform"));
}

void SeveralBlocks::addMaterial(Section& section) {
  QStringList titles;
  for (const Material& material : project_.document().project().materials) titles << text(material.name);
  std::set<QString> now;
  for (const BlockOverride& one : said_) now.insert(text(*one.material));
  auto* box = makeChoice(tr("Material"), titles, now);
  box->setObjectName(QStringLiteral("material"));
  connect(box, &QComboBox::activated, this, [this, titles](int index) {
    tryTo([&] {
      block_edits::setMaterial(project_, blocks_,
                               index > 0 ? std::optional(titles[index - 1].toStdString()) : std::nullopt);
    });
  });
  section.addRow(tr("Material"), box);
}

void SeveralBlocks::addMeshSize(Section& section) {
  auto* size = new NumberField(std::nullopt, {QStringLiteral("m"), QStringLiteral("m")});
  size->setObjectName(QStringLiteral("mesh_size"));
  size->setAccessibleName(tr("Mesh size"));
  size->allowNone(tr("as it is"));
  connect(size, &NumberField::committed, this,
          [this](double metres) { tryTo([&] { block_edits::setMeshSize(project_, blocks_, metres); }); });
  section.addRow(tr("Mesh size"), size, tr("Edge length of the tetrahedra of these blocks"));
}

void SeveralBlocks::addFacts() {
  const BlockSystem& system = *project_.system();
  const Project& project = project_.builtFrom();
  double volume = 0, mass = 0;
  std::size_t nodes = 0, tetrahedra = 0;
  std::map<QString, int> bodies, materials;
  QStringList names;
  for (const int index : blocks_) {
    const Block& block = system.blocks.at(static_cast<std::size_t>(index));
    volume += block.volume;
    nodes += block.mesh.nodes.size();
    tetrahedra += block.mesh.tetrahedra.size();
    ++bodies[words::body(block.body)];
    if (names.size() < most_names) names << text(block.name);
    const auto material = static_cast<std::size_t>(block.material);
    if (material >= project.materials.size()) continue;
    mass += block.volume * project.materials[material].density;
    ++materials[text(project.materials[material].name)];
  }
  if (blocks_.size() > static_cast<std::size_t>(names.size()))
    names << tr("and %1 more").arg(blocks_.size() - static_cast<std::size_t>(names.size()));
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
