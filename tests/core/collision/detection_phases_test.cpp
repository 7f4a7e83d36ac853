// The phases of a detection, each by itself, against every pair of faces.
#include "core/collision/adjacent_faces.h"
#include "core/collision/crowded_faces.h"
#include "core/collision/near_vertices.h"
#include "core/collision/separate_faces.h"
#include "tests/core/collision/detection_support.h"
#include "tests/support/catch.h"

using namespace handlebody;
using namespace handlebody::testing;

namespace {

//! The active vertices of a detection of what has moved, measured.
void lookAtMoved(DetectionWorkspace& work, std::span<const unsigned char> moved) {
  work.all = false;
  work.moved.mark(work.points.size(), work.faces, moved, work.stars, work.vertices);
  measure(work);
}

std::vector<FacePair> found(DetectionWorkspace& work) {
  sortUnique(work.pairs);
  return work.pairs;
}

}  // namespace

TEST_CASE("faces with a common vertex: the star test and the pairs of a star find what every pair does") {
  for (const TriangleSoup& soup : zoo::intersecting()) {
    DetectionWorkspace work = workspaceOf(soup);
    lookAtAll(work);
    AdjacentFaces adjacent;
    adjacent.test(work);
    CHECK(found(work) == everyPair(work, true));
  }
}

TEST_CASE("faces without a common vertex: by near vertices and by boxes the same pairs, and every one") {
  for (const TriangleSoup& soup : zoo::intersecting()) {
    DetectionWorkspace byVertices = workspaceOf(soup);
    lookAtAll(byVertices);
    const std::vector<FacePair> all = everyPair(byVertices, false);
    SeparateFaces separate;
    if (separate.test(byVertices)) CHECK(found(byVertices) == all);
    DetectionWorkspace byBoxes = workspaceOf(soup);
    CrowdedFaces crowded;
    crowded.test(byBoxes);
    CHECK(found(byBoxes) == all);
  }
}

TEST_CASE("of what has moved: with the vertices near by every wanted pair is found") {
  for (const TriangleSoup& soup : zoo::intersecting())
    for (const unsigned every : {2u, 9u, 50u}) {
      DetectionWorkspace work = workspaceOf(soup);
      lookAtMoved(work, someMoved(soup.points.size(), every, every));
      NearVertices near;
      near.add(work);
      const std::vector<FacePair> wanted = everyPair(work, false);
      SeparateFaces separate;
      if (!work.vertices.empty() && separate.test(work)) CHECK(found(work) == wanted);
      DetectionWorkspace byBoxes = workspaceOf(soup);
      lookAtMoved(byBoxes, someMoved(soup.points.size(), every, every));
      CrowdedFaces crowded;
      crowded.test(byBoxes);
      CHECK(found(byBoxes) == wanted);
    }
}

TEST_CASE(
    "vertices at rest that an active one can reach are added, each once, and hardly any on a far part") {
  const TriangleSoup ball = zoo::sphere(6);
  const TriangleSoup soup = zoo::both(ball, zoo::moved(ball, Vec3(100, 0, 0)));
  DetectionWorkspace work = workspaceOf(soup);
  std::vector<unsigned char> moved(soup.points.size(), 0);
  moved[0] = 1;
  lookAtMoved(work, moved);
  const std::vector<int> active = work.vertices;
  NearVertices near;
  near.add(work);
  std::vector<unsigned char> isListed(soup.points.size(), 0);
  for (const int v : work.vertices) ++isListed[v];
  std::size_t far = 0;
  for (int v = 0; v < static_cast<int>(soup.points.size()); ++v) {
    bool isNear = false;
    for (const int a : active) isNear = isNear || (soup.points[v] - soup.points[a]).norm() <= work.reach();
    CHECK(isListed[v] <= 1);
    if (isNear) CHECK(isListed[v] == 1);
    far += v >= static_cast<int>(ball.points.size()) && isListed[v] != 0;
  }
  CHECK(far < ball.points.size() / 10);
}
