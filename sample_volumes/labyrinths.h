#pragma once
// The shapes that are hard on the topology: linked, knotted, branched, porous, thin. Signed distances (mm,
// negative inside) in the volume's own frame.

#include "core/geometry/vec.h"

namespace handlebody::phantoms {

//! Two linked rings of 24 mm radius, 6 mm thick tubes, joined by a bridge. Genus 2.
double ringsDistance(const Vec3& p);
inline const Vec3 kRingsSeed(-36, 0, 0);

//! Tube of 5.5 mm radius about a trefoil knot. Genus 1.
double trefoilDistance(const Vec3& p);
Vec3 trefoilPoint(double t);
Vec3 trefoilDerivative(double t);
inline constexpr double kTrefoilTube = 5.5;

//! Tubes of 3 mm radius along the edges of a branched graph with three loops. Genus 3.
double treeDistance(const Vec3& p);
inline const Vec3 kTreeSeed(0, 0, -38);

//! Ball of 45 mm radius with nine bright balls of 2 to 10 mm radius in it. Nine cavities.
double ballsDistance(const Vec3& p);
inline constexpr int kBallsCavities = 9;

//! Plate of 4 mm with round rims.
double plateDistance(const Vec3& p);

//! Two balls joined by a bar of 2.5 mm radius. Genus 0.
double neckDistance(const Vec3& p);

//! One side of a gyroid of 40 mm period within a rounded cube. Genus 27, which no formula gives: the tests
//! count it on the ideal surface and, independently, on the voxels of the label.
double gyroidDistance(const Vec3& p);

}  // namespace handlebody::phantoms
