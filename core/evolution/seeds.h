#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/evolution/object_image.h"
#include "core/evolution/size_field.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! Radius (mm) of the largest ball around `centre` that lies in the object, at most `limit`.
double fittingRadius(const ObjectImage& image, const Vec3& centre, double limit);

//! Where within four voxels of a click in a region a ball of radius `wanted` (mm) fits, or the largest does:
//! a click between the grains of the noise, or on the object's rim. In other images the click itself.
Vec3 roomiestNear(const ObjectImage& image, const Vec3& centre, double wanted);

//! Gives every seed a radius: the one asked for, or what fits, and never so large that two balls come closer
//! than one edge length to each other. A radius that was asked for may reach beyond the object only where the
//! surface may shrink (`beyond`); elsewhere it is cut to what fits. A seed that lies in or too close to an
//! earlier ball is left out: that ball grows over it; so is a click without a radius in a region in which the
//! front of an earlier ball comes there.
std::vector<Seed> fitSeeds(const ObjectImage& image, const std::vector<Seed>& seeds, double edgeLength,
                           bool beyond);

//! True if in a region a front from one of the places comes to `to`, with room to spare.
bool comesAnyway(const ObjectImage& image, const std::vector<Vec3>& from, const Vec3& to, double edgeLength);

//! The ball that fits in the object around `asked`, or within a few voxels of it if `room` (mm from a place
//! to whatever is there already, less the distance to keep) leaves none there. None if there is no room.
std::optional<Seed> fitBall(const ObjectImage& image, const Seed& asked, double edgeLength,
                            const std::function<double(const Vec3&)>& room);

//! The sphere of a seed. Precondition: it has a radius.
TriangleSoup seedSphere(const Seed& seed, double edgeLength);

//! The spheres of the seeds as one mesh. Throws UsageError if it would have over two million triangles.
//! Precondition: every seed has a radius. Edges are longer where `sizes` has it so (null: nowhere), but for
//! small spheres, which stay round.
Mesh seedMesh(const std::vector<Seed>& seeds, double edgeLength, const SizeField* sizes = nullptr);

}  // namespace handlebody
