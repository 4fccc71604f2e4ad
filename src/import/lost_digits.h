#pragma once

#include "import/scene_stream.h"

namespace ink::import {

/// Notes the objects of a reply of Assimp's that lie so far from zero that its floats have lost
/// digits of the file: where two neighbours are more than 1e-5 of the object's diagonal apart, or,
/// where it is placed, of the scene's.
void note_lost_digits(ImportReply& reply);

}  // namespace ink::import
