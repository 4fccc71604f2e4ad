#pragma once

#include "scene/scene.h"

namespace ink::scene {

/// Makes one object for each material of an object, so that a line where materials meet on a smooth
/// surface is a seam to everyone: truth, cross-check and methods know objects alone.
///
/// The objects of an instance follow each other in its place, by material number, and are called
/// `NAME/material N`; an instance of one material stays as it is. What moves goes on moving.
void split_materials(Scene& scene);

}  // namespace ink::scene
