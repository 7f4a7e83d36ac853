#pragma once
// Pins as they are painted: strokes of a ball-shaped brush over the surface become pins, and an eraser takes
// them away.

#include <vector>

#include "core/evolution/constraints.h"

namespace handlebody {

//! Which vertices (mm, LPS) of the surface at an iteration the pins hold: those of that iteration what lies
//! in their balls, those of earlier ones what lies there and was `held` (one per vertex; by any pin) when the
//! surface was made; those of later ones nothing yet.
std::vector<bool> heldBy(const std::vector<Pin>& pins, const std::vector<Vec3>& vertices,
                         const std::vector<bool>& held, int iteration);

//! What the balls of a stroke hold of a surface with these vertices (mm, LPS) at an iteration. Balls that
//! hold none but what `held` (one per vertex) tells, or one before them holds, are left out.
std::vector<Pin> pinsOf(const std::vector<WallBall>& stroke, const std::vector<Vec3>& vertices,
                        const std::vector<bool>& held, int iteration);

//! The pins without those that have a vertex in common with one of the eraser's balls. `held`: one per
//! vertex, true if some pin holds it.
std::vector<Pin> unpinned(std::vector<Pin> pins, const std::vector<WallBall>& eraser,
                          const std::vector<Vec3>& vertices, const std::vector<bool>& held);

}  // namespace handlebody
