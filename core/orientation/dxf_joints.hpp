#pragma once

#include <string_view>

#include "orientation/joint_table.hpp"

namespace talus {

/// Joints as faces of a drawing (AutoCAD DXF as text): a plane is fitted to the corners of every 3DFACE and to every
/// 3-D POLYLINE, its set is the layer, the corners are where the joint ends. Lengths are in the unit that the drawing
/// names ($INSUNITS), metres where it names none. A line's number is that of the entity in the file; one whose corners
/// span no plane has a problem. Other entities are counted in the notes.
/// Throws InputError at "drawing" for what is no DXF text.
JointTable read_dxf_joints(std::string_view text);

}  // namespace talus
