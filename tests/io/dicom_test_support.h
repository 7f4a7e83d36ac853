#pragma once
// A writer of plain DICOM files for tests.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>

#include "tests/io/io_test_support.h"

namespace handlebody::test {

//! Further elements, by tag: VR and value. Not what a slice writes itself, nor between that of the groups 18
//! and 28 (18,1060 to 18,6011; 20,0013 to 20,0037; 28).
using MoreElements = std::map<std::uint32_t, std::pair<std::string, std::string>>;

struct Slice {
  std::string series = "1.2.3.4", study = "1.2.3";
  Vec3 position{0, 0, 0};
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();
  std::string spacing = "1.5\\0.75";  // between rows, then between columns
  std::string slope = "1", intercept = "0";
  int frames = 1, columns = 4, rows = 3;
  std::int16_t value = 0;                // of all pixels
  std::function<int(int, int)> pixel{};  // of column and row, instead
  std::string instance{};                // SOPInstanceUID; else made up
  std::string modality = "MR";
  int number = 0;                      // InstanceNumber
  int acquisition = 0;                 // AcquisitionNumber, if above 0
  bool placed = true;                  // position and orientation
  double frameTime = 0;                // ms
  double triggerTime = -1;             // ms, if not negative
  int temporalPosition = 0;            // if above 0, with a resolution of 40 ms
  double sliceDistance = 0;            // mm, SpacingBetweenSlices
  double regionDelta = 0;              // cm, of an ultrasound region
  std::vector<Vec3> framePositions{};  // functional groups
  std::vector<std::string> frameStacks{};
  MoreElements more{};
};

//! Explicit little-endian data elements.
class DicomText {
 public:
  void add(unsigned group, unsigned element, const std::string& vr, std::string value) {
    if (value.size() % 2) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
    put(group, 2);
    put(element, 2);
    bytes += vr;
    if (vr == "OB" || vr == "OW" || vr == "SQ") {
      put(0, 2);
      put(static_cast<unsigned>(value.size()), 4);
    } else {
      put(static_cast<unsigned>(value.size()), 2);
    }
    bytes += value;
  }
  void addShort(unsigned group, unsigned element, int value) {
    add(group, element, "US", std::string{static_cast<char>(value & 255), static_cast<char>(value >> 8)});
  }
  void addLong(unsigned group, unsigned element, std::uint32_t value) {
    add(group, element, "UL", std::string(reinterpret_cast<const char*>(&value), 4));
  }
  void addDouble(unsigned group, unsigned element, double value) {
    add(group, element, "FD", std::string(reinterpret_cast<const char*>(&value), 8));
  }
  void addSequence(unsigned group, unsigned element, const std::vector<DicomText>& items) {
    DicomText all;
    for (const DicomText& item : items) {
      all.put(0xfffe, 2);
      all.put(0xe000, 2);
      all.put(static_cast<unsigned>(item.bytes.size()), 4);
      all.bytes += item.bytes;
    }
    add(group, element, "SQ", all.bytes);
  }
  std::string bytes;

 private:
  void put(unsigned value, int size) {
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
  }
};

inline std::string list(std::initializer_list<double> values) {
  std::string text;
  for (double v : values) {
    char number[40];
    std::snprintf(number, sizeof number, "%.10g", v);
    text += (text.empty() ? "" : "\\") + std::string(number);
  }
  return text;
}

//! One macro of a functional group: a sequence of one item.
inline DicomText macro(unsigned group, unsigned element, const DicomText& content) {
  DicomText text;
  text.addSequence(group, element, {content});
  return text;
}

//! Ultrasound region of the whole image, in centimetres.
inline void addRegion(const Slice& s, DicomText& data) {
  DicomText region;
  region.addLong(0x18, 0x6018, 0);
  region.addLong(0x18, 0x601a, 0);
  region.addLong(0x18, 0x601c, static_cast<std::uint32_t>(s.columns));
  region.addLong(0x18, 0x601e, static_cast<std::uint32_t>(s.rows));
  region.addShort(0x18, 0x6024, 3);
  region.addShort(0x18, 0x6026, 3);
  region.addDouble(0x18, 0x602c, s.regionDelta);
  region.addDouble(0x18, 0x602e, 2 * s.regionDelta);
  data.addSequence(0x18, 0x6011, {region});
}

//! Orientation and pixel spacing for all frames, the position for each.
inline void addFunctionalGroups(const Slice& s, const std::string& orientation, DicomText& data) {
  DicomText plane, measures, shared;
  plane.add(0x20, 0x37, "DS", orientation);
  measures.add(0x28, 0x30, "DS", s.spacing);
  shared.bytes = macro(0x20, 0x9116, plane).bytes + macro(0x28, 0x9110, measures).bytes;
  std::vector<DicomText> frames;
  for (std::size_t i = 0; i < s.framePositions.size(); ++i) {
    const Vec3& p = s.framePositions[i];
    DicomText position, content;
    position.add(0x20, 0x32, "DS", list({p[0], p[1], p[2]}));
    if (!s.frameStacks.empty()) content.add(0x20, 0x9056, "SH", s.frameStacks[i]);
    DicomText frame = macro(0x20, 0x9111, content);
    frame.bytes += macro(0x20, 0x9113, position).bytes;
    frames.push_back(frame);
  }
  data.addSequence(0x5200, 0x9229, {shared});
  data.addSequence(0x5200, 0x9230, frames);
}

inline std::string dicomBytes(const Slice& s, const std::string& instance) {
  DicomText meta;
  meta.add(2, 0x02, "UI", "1.2.840.10008.5.1.4.1.1.4");
  meta.add(2, 0x03, "UI", instance);
  meta.add(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  DicomText data;
  auto more = s.more.begin();
  const auto addMore = [&](std::uint32_t before) {
    for (; more != s.more.end() && more->first < before; ++more)
      data.add(more->first >> 16, more->first & 0xffff, more->second.first, more->second.second);
  };
  addMore(0x00080016);
  data.add(8, 0x16, "UI", "1.2.840.10008.5.1.4.1.1.4");
  data.add(8, 0x18, "UI", s.instance.empty() ? instance : s.instance);
  addMore(0x00080060);
  data.add(8, 0x60, "CS", s.modality);
  addMore(0x0008103e);
  data.add(8, 0x103e, "LO", "made by hand");
  addMore(0x00180088);
  if (s.sliceDistance > 0) data.add(0x18, 0x88, "DS", list({s.sliceDistance}));
  addMore(0x00181060);
  if (s.triggerTime >= 0) data.add(0x18, 0x1060, "DS", list({s.triggerTime}));
  if (s.frameTime > 0) data.add(0x18, 0x1063, "DS", list({s.frameTime}));
  if (s.regionDelta > 0) addRegion(s, data);
  addMore(0x0020000d);
  data.add(0x20, 0x0d, "UI", s.study);
  data.add(0x20, 0x0e, "UI", s.series);
  addMore(0x00200012);
  if (s.acquisition > 0) data.add(0x20, 0x12, "IS", std::to_string(s.acquisition));
  data.add(0x20, 0x13, "IS", std::to_string(s.number));
  const Eigen::Matrix3d& d = s.direction;
  const std::string orientation = list({d(0, 0), d(1, 0), d(2, 0), d(0, 1), d(1, 1), d(2, 1)});
  const bool plain = s.placed && s.framePositions.empty();
  if (plain) data.add(0x20, 0x32, "DS", list({s.position[0], s.position[1], s.position[2]}));
  if (plain) data.add(0x20, 0x37, "DS", orientation);
  addMore(0x00200100);
  if (s.temporalPosition > 0) {
    data.add(0x20, 0x100, "IS", std::to_string(s.temporalPosition));
    data.add(0x20, 0x110, "DS", "40");
  }
  addMore(0x00280002);
  data.addShort(0x28, 0x02, 1);
  data.add(0x28, 0x04, "CS", "MONOCHROME2");
  if (s.frames > 1) data.add(0x28, 0x08, "IS", std::to_string(s.frames));
  data.addShort(0x28, 0x10, s.rows);
  data.addShort(0x28, 0x11, s.columns);
  if (!s.spacing.empty() && s.framePositions.empty()) data.add(0x28, 0x30, "DS", s.spacing);
  data.addShort(0x28, 0x100, 16);
  data.addShort(0x28, 0x101, 16);
  data.addShort(0x28, 0x102, 15);
  data.addShort(0x28, 0x103, 1);
  data.add(0x28, 0x1052, "DS", s.intercept);
  data.add(0x28, 0x1053, "DS", s.slope);
  addMore(0x52000000);
  if (!s.framePositions.empty()) addFunctionalGroups(s, orientation, data);
  std::string pixels;
  for (int f = 0; f < s.frames; ++f)
    for (int y = 0; y < s.rows; ++y)
      for (int x = 0; x < s.columns; ++x) {
        const int value = s.pixel ? s.pixel(x, y) : s.value + f;
        pixels += {static_cast<char>(value & 255), static_cast<char>(value >> 8)};
      }
  data.add(0x7fe0, 0x10, "OW", pixels);
  DicomText length;
  const auto n = static_cast<std::uint32_t>(meta.bytes.size());
  length.add(2, 0, "UL", std::string(reinterpret_cast<const char*>(&n), 4));
  return std::string(128, '\0') + "DICM" + length.bytes + meta.bytes + data.bytes;
}

//! An even oblique stack of `count` slices, 2.5 mm apart; slice i holds the value i. File names run against
//! the order in space.
inline std::vector<Slice> evenStack(int count) {
  std::vector<Slice> slices(count);
  const Eigen::Matrix3d direction = Eigen::AngleAxisd(0.4, Vec3(1, -1, 2).normalized()).toRotationMatrix();
  for (int i = 0; i < count; ++i) {
    Slice& s = slices[i];
    s.direction = direction;
    s.position = Vec3(-50, 20, 10) + 2.5 * i * direction.col(2);
    s.value = static_cast<std::int16_t>(i);
  }
  return slices;
}

inline void writeSeries(const std::string& folder, const std::vector<Slice>& slices) {
  fs::create_directories(folder);
  for (std::size_t i = 0; i < slices.size(); ++i)
    writeBytes(folder + "/" + std::to_string(1000 - i),
               dicomBytes(slices[i], slices[i].series + "." + std::to_string(i + 1)));
}

}  // namespace handlebody::test
