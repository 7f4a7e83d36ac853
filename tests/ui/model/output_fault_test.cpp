// Files that the open work is read from: none of them is written over.

#include "core/io/meshes/mesh_io.h"
#include "core/mesh/shapes.h"
#include "tests/ui/model/objects_support.h"

using namespace handlebody;
using namespace handlebody::ui;

namespace {

//! One object, which grows from a mesh on disk.
struct FromMesh : ObjectsWork {
  const QString mesh = torus.file("all_ball.stl");
  QByteArray before;

  FromMesh() {
    writeMesh(icosphere(opposite().centre, 3, 1.0), mesh.toStdString());
    before = bytesOf(mesh);
    bool isOpen = false;
    QObject::connect(&document, &Document::objectsOpened, [&] { isOpen = true; });
    document.openObjects({mesh, OpenAs::start});
    REQUIRE(waitFor([&] { return isOpen; }));
    document.removeObject(0);  // the one without a click
    rename(document, 0, "ball");
    REQUIRE(waitFor([&] { return isAtRest(document); }));
    REQUIRE(runToEnd(document));
  }
  template <typename Write>
  bool isRefused(Write&& write) {
    written.clear();
    failed.clear();
    write();
    waitFor([&] { return !written.isEmpty() || !failed.isEmpty(); });
    return failed.contains("read from it") && bytesOf(mesh) == before;
  }
};

}  // namespace

TEST_CASE("the mesh that an object was opened from is not written over, and it says why",
          "[output][opened]") {
  FromMesh work;
  Document& document = work.document;
  const QString& mesh = work.mesh;
  CHECK(work.isRefused([&] { document.exportResult(mesh, CoordinateSpace::lps); }));
  CHECK(work.isRefused([&] { document.exportObjects(mesh, CoordinateSpace::lps); }));
  CHECK(work.isRefused([&] {
    document.exportEachObject(work.torus.file("all.stl"), QStringLiteral(".stl"), CoordinateSpace::lps);
  }));
  CHECK(work.isRefused([&] { document.exportReport(mesh); }));
  CHECK(work.isRefused([&] { document.saveSession(mesh); }));
  CHECK(work.isRefused([&] { document.exportAnonymousSession(mesh); }));
  CHECK_FALSE(document.outputFault(mesh).isEmpty());
  const QString other = work.torus.file("other.stl"), session = work.torus.file("s.json");
  CHECK(work.exportActive(other));
  REQUIRE(work.save(session));
  CHECK(openAndWait(document, session));
}

TEST_CASE("nothing stands against a file before a volume is open", "[output]") {
  const Document document;
  CHECK(document.outputFault(QStringLiteral("x.stl")).isEmpty());
}
