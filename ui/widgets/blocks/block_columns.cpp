#include "widgets/blocks/block_columns.hpp"

#include <QObject>
#include <QStringList>

#include "mesh/unknowns.hpp"
#include "widgets/kit/model_words.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

using System = std::shared_ptr<const BlockSystem>;
const QString no_value = QStringLiteral("–");

const Block& blockOf(const System& system, int block) { return system->blocks[static_cast<std::size_t>(block)]; }

/// A column of numbers: what they are, and how they are written. An empty optional is a dash.
BlockColumn numberColumn(const QString& title, const QString& tip, std::function<std::optional<double>(int)> number,
                         std::function<QString(double)> write) {
  return {.title = title,
          .tip = tip,
          .value =
              [number](int block) {
                const auto value = number(block);
                return value ? QVariant(*value) : QVariant();
              },
          .text =
              [number, write](int block) {
                const auto value = number(block);
                return value ? write(*value) : no_value;
              }};
}

BlockColumn countColumn(const QString& title, const QString& tip, std::function<std::optional<double>(int)> number) {
  return numberColumn(title, tip, std::move(number), [](double count) { return numbers::fixed(count, 0); });
}

BlockColumn wordColumn(const QString& title, const QString& tip, std::function<QString(int)> words) {
  return {.title = title,
          .tip = tip,
          .isNumber = false,
          .value = [words](int block) { return QVariant(words(block)); },
          .text = words};
}

BlockColumn nameColumn(const System& system) {
  return wordColumn(QObject::tr("Block"), {}, [system](int block) { return text(blockOf(system, block).name); });
}

BlockColumn bodyColumn(const System& system) {
  auto column = wordColumn(QObject::tr("Body"), QObject::tr("What a block may do; one that was chosen has the reason"),
                           [system](int block) {
                             const Block& one = blockOf(system, block);
                             const QString body = words::body(one.body);
                             return one.body_reason.empty() ? body : QObject::tr("%1, chosen").arg(body);
                           });
  column.more = [system](int block) { return sentenceCase(text(blockOf(system, block).body_reason)); };
  return column;
}

QString leavingWords(const BlockFacts& facts) {
  if (facts.fixed) return QObject::tr("fixed");
  QStringList joints;
  for (const std::string& joint : facts.slides_on) joints << text(joint);
  joints.removeAll(QString());
  const QString words = text(to_string(facts.leaving.leaving));
  return joints.isEmpty() ? words : QObject::tr("%1: %2").arg(words, joints.join(QStringLiteral(", ")));
}

}  // namespace

std::vector<BlockColumn> blockColumns(System system, const Project& built,
                                      std::shared_ptr<const std::vector<BlockFacts>> facts) {
  QStringList materials, joints;
  for (const Material& material : built.materials) materials << text(material.name);
  for (const Joint& joint : built.joints) joints << text(joint.name);
  /// A figure of the facts, once they are known.
  const auto fact = [facts](auto figure) {
    return [facts, figure](int block) -> std::optional<double> {
      if (!facts) return {};
      return figure((*facts)[static_cast<std::size_t>(block)]);
    };
  };
  const auto factWords = [facts](auto words) {
    return [facts, words](int block) {
      return facts ? words((*facts)[static_cast<std::size_t>(block)]) : QObject::tr("…");
    };
  };
  const auto figures = [](double value) { return numbers::significant(value); };
  auto shape =
      numberColumn(QObject::tr("Slender"),
                   QObject::tr("Longest side over 3 V / A; above %1 a block is a sliver: mesh and contact have "
                               "trouble with it")
                       .arg(sliver_slenderness),
                   fact([](const BlockFacts& one) { return one.slenderness; }), figures);
  shape.isWarning = [facts](int block) {
    return facts && (*facts)[static_cast<std::size_t>(block)].slenderness > sliver_slenderness;
  };
  shape.more = [isSliver = shape.isWarning](int block) {
    return isSliver(block) ? QObject::tr("A sliver") : QString();
  };
  const auto jointNames = [joints](const BlockFacts& one) {
    QStringList names;
    for (const int joint : one.joints) names << joints.value(joint);
    return names.isEmpty() ? no_value : names.join(QStringLiteral(", "));
  };
  const auto factor = [](const BlockFacts& one) { return one.fixed ? std::optional<double>() : one.leaving.factor; };
  return {nameColumn(system),
          bodyColumn(system),
          numberColumn(
              QObject::tr("Volume m³"), {}, [system](int block) { return blockOf(system, block).volume; },
              [](double volume) { return numbers::significant(volume, 4); }),
          wordColumn(QObject::tr("Leaves"),
                     QObject::tr("Whether and how it can leave its place by block theory, and on which joints"),
                     factWords(leavingWords)),
          numberColumn(QObject::tr("F"),
                       QObject::tr("Factor of safety by limit equilibrium, under its own weight; – where nothing "
                                   "drives it"),
                       fact(factor), figures),
          countColumn(QObject::tr("Faces"), QObject::tr("Flat faces"),
                      fact([](const BlockFacts& one) { return one.faces; })),
          countColumn(QObject::tr("Free"), QObject::tr("Faces against no other block"),
                      fact([](const BlockFacts& one) { return one.free_faces; })),
          countColumn(QObject::tr("Neighbours"), QObject::tr("Blocks that it lies against"),
                      fact([](const BlockFacts& one) { return static_cast<double>(one.neighbours.size()); })),
          wordColumn(QObject::tr("Joints"), QObject::tr("Joints of its faces"), factWords(jointNames)),
          shape,
          wordColumn(QObject::tr("Material"), {}, [system, materials](int block) {
            return materials.value(blockOf(system, block).material, no_value);
          })};
}

std::vector<BlockColumn> meshColumns(System system, std::shared_ptr<const MeshSurvey> survey) {
  const auto quality = [survey](auto figure) {
    return [survey, figure](int block) -> std::optional<double> {
      if (!survey) return {};
      const auto& rated = survey->blocks[static_cast<std::size_t>(block)];
      return rated ? std::optional<double>(figure(*rated)) : std::nullopt;
    };
  };
  const auto ratio = [](double value) { return numbers::fixed(value, 3); };
  const auto degrees = [](double value) { return numbers::fixed(value, 1); };
  return {
      nameColumn(system),
      countColumn(QObject::tr("Tetrahedra"), {},
                  [system](int block) { return static_cast<double>(blockOf(system, block).mesh.tetrahedra.size()); }),
      numberColumn(QObject::tr("Worst"),
                   QObject::tr("Least quality of its tetrahedra: 3 × inscribed over circumscribed radius, 1 of a "
                               "regular one, 0 of a flat one"),
                   quality([](const MeshQuality& one) { return one.worst; }), ratio),
      numberColumn(QObject::tr("Angle °"),
                   QObject::tr("Smallest angle between two faces of a tetrahedron; 70.5° of a regular one"),
                   quality([](const MeshQuality& one) { return one.smallest_dihedral; }), degrees),
      numberColumn(QObject::tr("Mean"), QObject::tr("Mean quality of its tetrahedra"),
                   quality([](const MeshQuality& one) { return one.mean; }), ratio),
      countColumn(QObject::tr("Nodes"), {},
                  [system](int block) { return static_cast<double>(blockOf(system, block).mesh.nodes.size()); }),
      countColumn(QObject::tr("Unknowns"), QObject::tr("Of its motion"),
                  [system](int block) { return static_cast<double>(unknowns_of(blockOf(system, block))); }),
      bodyColumn(system)};
}

}  // namespace talus
