#include "widgets/project/motion_rows.hpp"

#include "mesh/block.hpp"
#include "results/frame.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

bool knowsMotions(const BlockSystem* system, const Frame* frame) {
  return system && frame && !frame->motions.empty() && frame->motions.size() == system->blocks.size();
}

PageRows motionRows(const BlockSystem& system, const Frame& frame) {
  PageRows content{QObject::tr("Motion of blocks"),
                   {QObject::tr("Block"), QObject::tr("Motion"), QObject::tr("Trend/plunge"), QObject::tr("Moved m")},
                   2,
                   {},
                   QObject::tr("All blocks are fixed.")};
  content.roomy = 1;
  const MotionNames names = motion_names(system);
  size_t node = 0;
  for (size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    double moved = 0;
    for (size_t n = 0; n < block.mesh.nodes.size(); ++n) moved = std::max(moved, frame.displacement[node++].norm());
    if (block.body == BodyKind::fixed) continue;
    const MotionClass& motion = frame.motions[b];
    content.rows.push_back({{Item::Kind::block, static_cast<int>(b)},
                            {text(block.name), text(motion_text(motion, names)), text(attitude_text(motion.direction)),
                             numbers::significant(moved)}});
  }
  return content;
}

QString motionSentence(const BlockSystem& system, const MotionClass& motion) {
  const QString words = text(motion_text(motion, motion_names(system)));
  return motion.direction.isZero() ? words : QObject::tr("%1, to %2").arg(words, text(attitude_text(motion.direction)));
}

}  // namespace talus
