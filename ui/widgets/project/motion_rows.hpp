#pragma once

#include "widgets/project/page_table.hpp"

namespace talus {

struct BlockSystem;
struct Frame;
struct MotionClass;

/// Whether it is known of every block how it moves in this frame. Either may be null.
bool knowsMotions(const BlockSystem* system, const Frame* frame);

/// How each block that may move does so in a frame: class, trend and plunge, largest displacement.
PageRows motionRows(const BlockSystem& system, const Frame& frame);

/// "sliding on J1 (B1), to 120°/35°".
QString motionSentence(const BlockSystem& system, const MotionClass& motion);

}  // namespace talus
