#include "core/collision/self_intersection.h"

#include <algorithm>

#include "core/collision/adjacent_faces.h"
#include "core/collision/crowded_faces.h"
#include "core/collision/detection_workspace.h"
#include "core/collision/near_vertices.h"
#include "core/collision/separate_faces.h"

namespace handlebody {

//! The workspace, and the phases that it is handed to. Precondition of both runs: points, faces and stars are
//! those of one mesh.
struct CollisionDetector::Tables {
  DetectionWorkspace work;
  AdjacentFaces adjacent;
  NearVertices near;
  SeparateFaces separate;
  CrowdedFaces crowded;

  void runAll();
  void runMoved(std::span<const unsigned char> moved);
  void testSeparate();
};

void CollisionDetector::Tables::runAll() {
  work.all = true;
  work.pairs.clear();
  work.vertices.clear();
  work.sizes.resize(work.points.size());
  work.longestSquared = 0;
  for (int v = 0; v < work.stars.vertexCount(); ++v) {
    if (work.stars.corners(v).empty()) continue;
    work.vertices.push_back(v);
  }
  adjacent.test(work);
  for (const int v : work.vertices)
    work.longestSquared = std::max(work.longestSquared, work.sizes[v].longestEdge);
  testSeparate();
  sortUnique(work.pairs);
}

void CollisionDetector::Tables::runMoved(std::span<const unsigned char> moved) {
  work.all = false;
  work.pairs.clear();
  work.sizes.resize(work.points.size());
  work.moved.mark(work.points.size(), work.faces, moved, work.stars, work.vertices, work.threads);
  adjacent.test(work);
  near.add(work);
  testSeparate();
  work.moved.clear(work.vertices);
  sortUnique(work.pairs);
}

void CollisionDetector::Tables::testSeparate() {
  if (work.vertices.empty()) return;  // nothing moved
  if (!separate.test(work)) crowded.test(work);
}

CollisionDetector::CollisionDetector() : tables_(std::make_unique<Tables>()) {}
CollisionDetector::~CollisionDetector() = default;
CollisionDetector::CollisionDetector(CollisionDetector&&) noexcept = default;
CollisionDetector& CollisionDetector::operator=(CollisionDetector&&) noexcept = default;

void CollisionDetector::use(BroadPhase phase) { tables_->separate.use(phase); }

void CollisionDetector::useThreads(int threads) { tables_->work.threads = std::max(1, threads); }

const std::vector<FacePair>& CollisionDetector::detectAll(std::span<const Vec3> points,
                                                          std::span<const Triangle> faces) {
  tables_->work.points = points;
  tables_->work.faces = faces;
  tables_->work.stars.build(points.size(), faces);
  tables_->runAll();
  return tables_->work.pairs;
}

const std::vector<FacePair>& CollisionDetector::detectMoved(std::span<const Vec3> points,
                                                            std::span<const Triangle> faces,
                                                            std::span<const unsigned char> moved) {
  tables_->work.points = points;
  tables_->work.faces = faces;
  tables_->work.stars.build(points.size(), faces);
  tables_->runMoved(moved);
  return tables_->work.pairs;
}

const std::vector<FacePair>& CollisionDetector::detectMoved(const Mesh& mesh,
                                                            std::span<const unsigned char> moved) {
  tables_->work.points = mesh.positions();
  tables_->work.faces = mesh.faces();
  tables_->work.stars.readFrom(mesh);
  tables_->runMoved(moved);
  return tables_->work.pairs;
}

std::vector<FacePair> findSelfIntersections(std::span<const Vec3> points, std::span<const Triangle> faces) {
  return CollisionDetector().detectAll(points, faces);
}

}  // namespace handlebody
