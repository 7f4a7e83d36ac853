// .msh, .vtu and .inp.

#include <cctype>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

#include "core/cancellation.h"
#include "core/io/atomic_file.h"
#include "core/io/lowered.h"
#include "core/io/tetrahedra/tetrahedra.h"
#include "core/version.h"

namespace handlebody {

namespace {

std::string endingOfTetrahedra(const std::string& path) {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? "" : lowered(path.substr(dot));
}

struct Contents {
  const Tetrahedra& tetrahedra;
  const std::vector<ExportedObject>& objects;
  CoordinateSpace space;

  Vec3 point(std::size_t i) const {
    const Vec3& p = tetrahedra.points[i];
    return space == CoordinateSpace::ras ? Vec3(-p.x(), -p.y(), p.z()) : p;
  }
  const ObjectLabel& label(std::size_t cell) const { return objects[tetrahedra.object[cell]].label; }
  const char* spaceName() const { return space == CoordinateSpace::ras ? "RAS" : "LPS"; }
};

void writeMsh(const Contents& c, std::ostream& out) {
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << c.objects.size() << "\n";
  for (const ExportedObject& o : c.objects) out << "3 " << o.label.value << " \"" << o.label.name << "\"\n";
  out << "$EndPhysicalNames\n$Nodes\n" << c.tetrahedra.points.size() << "\n";
  for (std::size_t i = 0; i < c.tetrahedra.points.size(); ++i) {
    const Vec3 p = c.point(i);
    out << i + 1 << " " << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  out << "$EndNodes\n$Elements\n" << c.tetrahedra.cells.size() << "\n";
  for (std::size_t i = 0; i < c.tetrahedra.cells.size(); ++i) {
    giveUpIfCancelled();
    const int value = c.label(i).value;
    out << i + 1 << " 4 2 " << value << " " << value;
    for (const int v : c.tetrahedra.cells[i]) out << " " << v + 1;
    out << "\n";
  }
  out << "$EndElements\n";
}

//! Names of sets in Abaqus: letters, digits and underscores, a letter first; the label keeps them apart.
std::string setName(const ObjectLabel& label) {
  std::string name = "OBJECT_" + std::to_string(label.value) + "_";
  for (const char c : label.name)
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? static_cast<char>(std::toupper(c)) : '_';
  return name.substr(0, 80);
}

void writeInp(const Contents& c, std::ostream& out) {
  out << "*HEADING\nHandlebody " HANDLEBODY_VERSION ", mm, " << c.spaceName() << "\n*NODE\n";
  for (std::size_t i = 0; i < c.tetrahedra.points.size(); ++i) {
    const Vec3 p = c.point(i);
    out << i + 1 << ", " << p.x() << ", " << p.y() << ", " << p.z() << "\n";
  }
  int before = -1;
  for (std::size_t i = 0; i < c.tetrahedra.cells.size(); ++i) {
    giveUpIfCancelled();
    if (c.tetrahedra.object[i] != before) {
      before = c.tetrahedra.object[i];
      out << "*ELEMENT, TYPE=C3D4, ELSET=" << setName(c.label(i)) << "\n";
    }
    out << i + 1;
    for (const int v : c.tetrahedra.cells[i]) out << ", " << v + 1;
    out << "\n";
  }
}

//! VTK's XML, in text: any version reads it.
void writeVtu(const Contents& c, std::ostream& out) {
  const std::size_t cells = c.tetrahedra.cells.size();
  const char* array = "<DataArray type=\"";
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<FieldData>\n<Array type=\"String\" "
         "Name=\"SPACE\" "
         "NumberOfTuples=\"1\" format=\"ascii\">\n";
  for (const char* s = c.spaceName(); *s; ++s) out << static_cast<int>(*s) << " ";
  out << "0\n</Array>\n</FieldData>\n<Piece NumberOfPoints=\"" << c.tetrahedra.points.size()
      << "\" NumberOfCells=\"" << cells << "\">\n<CellData Scalars=\"label\">\n"
      << array << "Int32\" Name=\"label\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < cells; ++i) out << c.label(i).value << "\n";
  out << "</DataArray>\n</CellData>\n<Points>\n"
      << array << "Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < c.tetrahedra.points.size(); ++i) {
    const Vec3 p = c.point(i);
    out << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  out << "</DataArray>\n</Points>\n<Cells>\n" << array << "Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const auto& t : c.tetrahedra.cells) {
    giveUpIfCancelled();
    out << t[0] << " " << t[1] << " " << t[2] << " " << t[3] << "\n";
  }
  out << "</DataArray>\n" << array << "Int32\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < cells; ++i) out << 4 * (i + 1) << "\n";
  out << "</DataArray>\n" << array << "UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < cells; ++i) out << "10\n";
  out << "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

bool isTetrahedraPath(const std::string& path) {
  const std::string ending = endingOfTetrahedra(path);
  return ending == ".msh" || ending == ".vtu" || ending == ".inp";
}

void writeTetrahedra(const Tetrahedra& tetrahedra, const std::vector<ExportedObject>& objects,
                     const std::string& path, CoordinateSpace space) {
  const std::string ending = endingOfTetrahedra(path);
  writeAtomically(path, [&](const std::string& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.imbue(std::locale::classic());
    out.precision(std::numeric_limits<double>::max_digits10);
    const Contents contents{tetrahedra, objects, space};
    (ending == ".msh" ? writeMsh : ending == ".inp" ? writeInp : writeVtu)(contents, out);
    if (!out.flush()) refuseOutput(path, FindingKind::diskMayBeFull);
  });
}

}  // namespace handlebody
