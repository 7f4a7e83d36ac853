// Encapsulated STL (DICOM Supplement 205), through DCMTK's data sets.

#include <Eigen/Geometry>
#include <cstring>

#include "core/io/atomic_file.h"
#include "core/io/dicom/dicom_class.h"
#include "core/io/dicom/dicom_dataset.h"
#include "core/io/meshes/mesh_files.h"
#include "core/version.h"

namespace handlebody {

namespace {

void put(DcmItem& data, const DcmTagKey& tag, const std::string& value) {
  data.putAndInsertString(tag, value.c_str());
}

void append(std::string& bytes, const Vec3& v) {
  for (int a = 0; a < 3; ++a) {
    const auto part = static_cast<float>(v[a]);
    bytes.append(reinterpret_cast<const char*>(&part), sizeof part);
  }
}

//! A binary STL; the header says the space, as in those of writeMesh.
std::string stlBytes(const std::vector<ExportedObject>& objects) {
  std::string bytes = spaceMark(CoordinateSpace::lps) + " Handlebody binary STL, mm";
  bytes.resize(80, ' ');
  std::uint32_t count = 0;
  for (const ExportedObject& o : objects) count += static_cast<std::uint32_t>(o.mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const ExportedObject& o : objects)
    for (const Triangle& t : o.mesh.triangles) {
      const auto at = [&](std::size_t i) -> const Vec3& { return o.mesh.points[t[i]]; };
      append(bytes, (at(1) - at(0)).cross(at(2) - at(0)).normalized());
      for (std::size_t i = 0; i < 3; ++i) append(bytes, at(i));
      bytes.append(2, '\0');
    }
  return bytes;
}

void addSeries(DcmItem& data, const DicomOrigin& origin, const DicomContent& content) {
  put(data, DCM_SOPClassUID, kEncapsulatedStlClass);
  put(data, DCM_SOPInstanceUID, dicom::newUid());
  put(data, DCM_Modality, "M3D");
  put(data, DCM_SeriesInstanceUID, dicom::newUid());
  put(data, DCM_SeriesNumber, dicom::kSeriesNumber);
  put(data, DCM_InstanceNumber, "1");
  const bool own = content.anonymous || origin.frameOfReference.empty();
  put(data, DCM_FrameOfReferenceUID, own ? dicom::newUid() : origin.frameOfReference);
  data.insertEmptyElement(DCM_PositionReferenceIndicator, false);
  put(data, DCM_Manufacturer, dicom::kMaker);
  put(data, DCM_ManufacturerModelName, dicom::kMaker);
  put(data, DCM_DeviceSerialNumber, "0");
  put(data, DCM_SoftwareVersions, HANDLEBODY_VERSION);
}

//! The images that it was made from.
void addSources(DcmItem& data, const DicomOrigin& origin, const DicomContent& content) {
  if (content.anonymous || !namesImages(origin)) return;
  for (const DicomImage& image : origin.images) {
    DcmItem* item = nullptr;
    data.findOrCreateSequenceItem(DCM_SourceInstanceSequence, item, -2);  // a new one at the end
    put(*item, DCM_ReferencedSOPClassUID, image.sopClass);
    put(*item, DCM_ReferencedSOPInstanceUID, image.instance);
    if (image.frame > 0) put(*item, DCM_ReferencedFrameNumber, std::to_string(image.frame));
  }
}

//! None of its modules (PS3.3 C.24.2, C.35.1) has a place for the content's creator.
void addDocument(DcmItem& data, const std::vector<ExportedObject>& objects, const DicomContent& content) {
  std::string title;
  for (const ExportedObject& o : objects) title += (title.empty() ? "" : ", ") + o.label.name;
  put(data, DCM_DocumentTitle, title);
  put(data, DCM_ContentDescription, content.description);
  put(data, DCM_BurnedInAnnotation, "NO");
  put(data, DCM_MIMETypeOfEncapsulatedDocument, "model/stl");
  data.insertEmptyElement(DCM_AcquisitionDateTime, true);
  data.insertEmptyElement(DCM_ConceptNameCodeSequence, true);
  DcmItem* unit = nullptr;
  data.findOrCreateSequenceItem(DCM_MeasurementUnitsCodeSequence, unit, 0);
  put(*unit, DCM_CodeValue, "mm");
  put(*unit, DCM_CodingSchemeDesignator, "UCUM");
  put(*unit, DCM_CodeMeaning, "mm");
}

}  // namespace

void writeDicomStl(const std::vector<ExportedObject>& objects, const DicomOrigin& origin,
                   const DicomContent& content, const std::string& path) {
  dicom::checkExport(origin, content, path);
  std::string stl = stlBytes(objects);
  constexpr std::size_t kLongestElement = 0xfffffffe;  // of a DICOM element
  if (stl.size() > kLongestElement) refuseOutput(path, FindingKind::dicomMeshTooLarge);
  DcmDataset data;
  dicom::Texts texts{content.description};
  for (const ExportedObject& object : objects) texts.push_back(object.label.name);
  dicom::addPatientAndStudy(data, origin, content, texts, path);
  addSeries(data, origin, content);
  addSources(data, origin, content);
  dicom::addReferencedSeries(data, origin, content);
  addDocument(data, objects, content);
  dicom::addContentDate(data, content);
  data.putAndInsertUint32(DCM_EncapsulatedDocumentLength, static_cast<Uint32>(stl.size()));
  if (stl.size() % 2) stl += '\0';
  dicom::require(
      data.putAndInsertUint8Array(DCM_EncapsulatedDocument, reinterpret_cast<const Uint8*>(stl.data()),
                                  static_cast<unsigned long>(stl.size())),
      path, "the mesh cannot be put into it");
  dicom::save(data, DCM_EncapsulatedDocument, path);
}

}  // namespace handlebody
