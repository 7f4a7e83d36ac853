#include "core/io/formats/sequence_writer.h"

#include <zlib.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "core/io/atomic_file.h"
#include "core/io/formats/byte_stream.h"
#include "core/io/formats/label_map.h"
#include "core/io/lowered.h"
#include "core/told_error.h"

namespace handlebody {
namespace {

static_assert(std::endian::native == std::endian::little, "headers are written as they lie in memory");

constexpr int kLargestNifti = 32767;  // sizes are held in 16 bits

//! NIfTI-1, 348 bytes and 4 that say that nothing follows before the voxels. Fields:
//! https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h
class NiftiBytes {
 public:
  template <typename T>
  void put(std::size_t at, T value) {
    std::memcpy(bytes_.data() + at, &value, sizeof value);
  }
  void putFloats(std::size_t at, std::initializer_list<double> values) {
    for (const double v : values) {
      put(at, static_cast<float>(v));
      at += sizeof(float);
    }
  }
  std::string text() const { return {bytes_.begin(), bytes_.end()}; }

 private:
  std::array<char, 352> bytes_{};
};

std::int16_t niftiType(VoxelType type) {
  static constexpr std::int16_t kCodes[] = {2, 256, 512, 4, 768, 8, 16, 64};
  return kCodes[static_cast<int>(type)];
}

//! Index to RAS mm, as quaternion and offset, and as rows.
void putGeometry(const Grid& grid, NiftiBytes& to) {
  const Vec3 ras(-1, -1, 1);
  Eigen::Matrix3d axes = ras.asDiagonal() * grid.direction;
  const Vec3 offset = ras.cwiseProduct(grid.origin);
  for (int row = 0; row < 3; ++row)
    to.putFloats(280 + 16 * static_cast<std::size_t>(row),
                 {axes(row, 0) * grid.spacing[0], axes(row, 1) * grid.spacing[1],
                  axes(row, 2) * grid.spacing[2], offset[row]});
  const double handed = axes.determinant() < 0 ? -1 : 1;
  axes.col(2) *= handed;
  Eigen::Quaterniond q(axes);
  if (q.w() < 0) q.coeffs() *= -1;
  to.putFloats(76, {handed, grid.spacing[0], grid.spacing[1], grid.spacing[2]});
  to.putFloats(256, {q.x(), q.y(), q.z(), offset[0], offset[1], offset[2]});
  to.put<std::int16_t>(252, 1);  // both codes: scanner coordinates
  to.put<std::int16_t>(254, 1);
}

std::string niftiHeader(const SequenceLayout& layout, const std::string& path) {
  NiftiBytes header;
  header.put<std::int32_t>(0, 348);
  header.put<std::int16_t>(40, 4);
  std::size_t at = 42;
  for (const int n :
       {layout.grid.size[0], layout.grid.size[1], layout.grid.size[2], layout.frames, 1, 1, 1}) {
    if (n > kLargestNifti) refuseOutput(path, FindingKind::niftiTooLarge);
    header.put(at, static_cast<std::int16_t>(n));
    at += 2;
  }
  header.put(70, niftiType(layout.type));
  header.put(72, static_cast<std::int16_t>(8 * bytesPerVoxel(layout.type)));
  putGeometry(layout.grid, header);
  const double step = evenStep(layout.times);
  header.putFloats(92, {step / 1000});
  header.putFloats(108, {352, 1, 0});
  header.put(123, static_cast<char>(step > 0 ? 2 | 8 : 2));  // mm, s
  std::string text = header.text();
  text.replace(344, 4, std::string("n+1\0", 4));
  return text;
}

std::string nrrdHeader(const SequenceLayout& layout) {
  static constexpr const char* kTypes[] = {"unsigned char", "signed char", "unsigned short", "short",
                                           "unsigned int",  "int",         "float",          "double"};
  const Grid& g = layout.grid;
  std::ostringstream out;
  out.precision(17);
  out << "NRRD0005\ntype: " << kTypes[static_cast<int>(layout.type)] << "\ndimension: 4\n"
      << "space: left-posterior-superior\nsizes: " << g.size[0] << ' ' << g.size[1] << ' ' << g.size[2] << ' '
      << layout.frames << "\nspace directions:";
  for (int a = 0; a < 3; ++a) {
    const Vec3 v = g.spacing[a] * g.direction.col(a);
    out << " (" << v[0] << ',' << v[1] << ',' << v[2] << ')';
  }
  out << " none\nkinds: domain domain domain list\nlabels: \"\" \"\" \"\" \""
      << (layout.times.milliseconds.empty() ? "frame" : "time") << "\"\n";
  if (!layout.times.milliseconds.empty()) out << "units: \"\" \"\" \"\" \"ms\"\n";
  out << "endian: little\nencoding: gzip\nspace origin: (" << g.origin[0] << ',' << g.origin[1] << ','
      << g.origin[2] << ")\n";
  if (!layout.times.milliseconds.empty()) {
    out << "axis 3 index type:=numeric\naxis 3 index values:=";
    for (std::size_t i = 0; i < layout.times.milliseconds.size(); ++i)
      out << (i ? " " : "") << layout.times.milliseconds[i];
    out << '\n';
  }
  out << '\n';
  return out.str();
}

//! A file that zlib writes into; complains as soon as it cannot.
class Output {
 public:
  Output(const std::string& temporary, const char* mode, std::string path)
      : file_(gzopen(temporary.c_str(), mode)), path_(std::move(path)) {
    if (!file_) refuseOutput(path_, FindingKind::fileNotOpened);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() {
    if (file_) gzclose(file_);
  }
  void write(const void* bytes, std::size_t n) {
    constexpr std::size_t kPart = 1u << 30;  // zlib counts in 32 bits
    for (const char* at = static_cast<const char*>(bytes); n > 0;) {
      const auto part = static_cast<unsigned>(std::min(n, kPart));
      if (gzwrite(file_, at, part) != static_cast<int>(part)) refuseOutput(path_, FindingKind::diskMayBeFull);
      at += part;
      n -= part;
    }
  }
  void close() {
    gzFile file = file_;
    file_ = nullptr;
    if (gzclose(file) != Z_OK) refuseOutput(path_, FindingKind::diskMayBeFull);
  }

 private:
  gzFile file_;
  std::string path_;
};

struct Frames {
  std::uint64_t offset;       // in the file, of the stream
  std::uint64_t before;       // in the stream, of the first frame
  ByteStream::Coding coding;  // of the stream
  std::vector<uLong> checks;  // crc32 of each frame
};

void verify(const Frames& written, std::size_t bytes, const std::string& temporary, const std::string& path) {
  bool same = true;
  try {
    ByteStream stream(temporary, written.offset, written.coding);
    stream.skip(written.before);
    std::vector<unsigned char> back(bytes);
    for (const uLong check : written.checks) {
      stream.readAll(back.data(), bytes);
      same = same && crc32_z(0, back.data(), bytes) == check;
    }
    stream.checkEnd();
  } catch (const InputError&) {
    same = false;  // said below, with the right name
  }
  if (!same) refuseOutput(path, FindingKind::notOnDisk);
}

void writeTo(const std::string& temporary, const SequenceLayout& layout, const std::string& path,
             const std::function<Volume(int)>& frame) {
  const std::string name = lowered(path);
  const bool isNrrd = name.ends_with(".nrrd"), isPlain = name.ends_with(".nii");
  const std::string header = isNrrd ? nrrdHeader(layout) : niftiHeader(layout, path);
  Frames written{0, header.size(), isPlain ? ByteStream::Coding::raw : ByteStream::Coding::deflate, {}};
  if (isNrrd) {
    Output plain(temporary, "wbT", path);  // T: as it is
    plain.write(header.data(), header.size());
    plain.close();
    written = {header.size(), 0, ByteStream::Coding::deflate, {}};
  }
  Output file(temporary, isNrrd ? "ab6" : isPlain ? "wbT" : "wb6", path);
  if (!isNrrd) file.write(header.data(), header.size());
  const std::size_t bytes = layout.grid.voxelCount() * bytesPerVoxel(layout.type);
  for (int i = 0; i < layout.frames; ++i) {
    const Volume volume = frame(i);
    if (volume.grid.size != layout.grid.size || volume.type != layout.type)
      throw std::logic_error("a frame of a sequence has another size or type");
    const auto* voxels = static_cast<const unsigned char*>(volume.voxels.get());
    written.checks.push_back(crc32_z(0, voxels, bytes));
    file.write(voxels, bytes);
  }
  file.close();
  verify(written, bytes, temporary, path);
}

}  // namespace

bool isSequencePath(const std::string& path) {
  const std::string name = lowered(path);
  return (name.ends_with(".nii") || name.ends_with(".nii.gz") || name.ends_with(".nrrd")) &&
         !isSlicerSegmentationPath(path);
}

void writeSequence(const SequenceLayout& layout, const std::string& path,
                   const std::function<Volume(int frame)>& frame) {
  if (!isSequencePath(path)) throw Told<UsageError>(Finding(FindingKind::noSequenceEnding, {{"file", path}}));
  writeAtomically(path, [&](const std::string& temporary) { writeTo(temporary, layout, path, frame); });
}

std::string numberedPath(const std::string& path, int frame) {
  const std::filesystem::path whole(path);
  char number[16];
  std::snprintf(number, sizeof number, "_%04d", frame);
  return (whole.parent_path() / (whole.stem().string() + number + whole.extension().string())).string();
}

std::string collectionPath(const std::string& path) {
  return std::filesystem::path(path).replace_extension(".pvd").string();
}

void writeCollection(const std::string& path, const std::vector<int>& files, const TimeAxis& times,
                     FileSet* set) {
  std::ostringstream out;
  out.precision(12);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n"
         "  <Collection>\n";
  for (const int frame : files) {
    std::string name = std::filesystem::path(numberedPath(path, frame)).filename().string(), quoted;
    for (const char c : name)
      quoted += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
    const auto at = static_cast<std::size_t>(frame);
    out << "    <DataSet timestep=\"" << (at < times.milliseconds.size() ? times.milliseconds[at] : frame)
        << "\" part=\"0\" file=\"" << quoted << "\"/>\n";
  }
  out << "  </Collection>\n</VTKFile>\n";
  writeTextAtomically(collectionPath(path), out.str(), set);
}

}  // namespace handlebody
