#include "core/io/report/label_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <set>

#include "core/io/dicom/dicom_segments.h"
#include "core/io/refuse_input.h"
#include "core/told_error.h"

namespace handlebody {

namespace {

using K = FindingKind;

//! Of the voxels that are not 0, kMaxLabels + 1 at most.
void addValues(const Volume& labels, int shift, std::set<int>& values) {
  visitVoxels(labels, [&](const auto* value) {
    double last = 0;
    for (std::size_t i = 0; i < labels.grid.voxelCount() && values.size() <= kMaxLabels; ++i) {
      const auto v = static_cast<double>(value[i]);
      if (v == last || v == 0) continue;
      values.insert(static_cast<int>(std::lround(v)) + shift);
      last = v;
    }
  });
}

//! "1 'liver', 2 'spleen'"
std::string namesIn(const FileLabels& labels) {
  std::string names;
  for (const auto& [number, label] : labels)
    if (!label.name.empty())
      names += (names.empty() ? "" : ", ") + std::to_string(number) + " '" + label.name + "'";
  return names;
}

}  // namespace

LabelFile::LabelFile(const std::string& path, const DecoderSettings& decoder, std::optional<int> frame)
    : path_(path), decoder_(decoder) {
  LoadedVolume loaded = loadVolume(path, {.frame = frame, .decoder = decoder});
  info_ = std::move(loaded.info);
  read_ = std::move(loaded.volume);
  if (!holdsWholeNumbers(read_)) refuseInput(path, K::notWholeNumbers);
  if (info_.layers == 1) return;
  readLayer_ = frame.value_or(0);
  if (info_.layers > static_cast<int>(kMaxLabels))
    throw Told<InputError>(Finding(K::tooManyLabels, {{"file", path}, {"most", kMaxLabels}}));
  std::erase_if(info_.warnings, [](const Finding& w) { return w.kind == K::firstLayerUsed; });
  shifts_ = slicerLayerShifts(path);
}

//! That it is a segmentation is what was asked for, and --frame chooses of the volume.
std::vector<Finding> LabelFile::warnings() const {
  std::vector<Finding> told;
  for (const Finding& w : info_.warnings) {
    if (w.kind == K::isSegmentation) continue;
    const bool isFrame = w.kind == K::frameZeroUsed;
    told.push_back(
        {K::ofFile, {{"file", path_}}, isFrame ? Finding(K::firstFrameUsed, {{"frames", info_.frames}}) : w});
  }
  return told;
}

const Volume& LabelFile::layer(int index) {
  if (index == readLayer_) return read_;
  readLayer_ = -1;  // none, if that fails
  read_ = {};       // before the next one takes as much
  read_ = readVolume(path_, {.frame = index, .decoder = decoder_});
  if (!holdsWholeNumbers(read_)) refuseInput(path_, K::notWholeNumbers);
  readLayer_ = index;
  return read_;
}

int LabelFile::shiftOf(int layer) const {
  const auto at = static_cast<std::size_t>(layer);
  return at < shifts_.size() ? shifts_[at] : 0;
}

//! In one pass: a layer may take as long to read as all of them.
void LabelFile::findLabels() {
  if (!layerOf_.empty()) return;
  for (int l = 0; l < info_.layers; ++l) {
    std::set<int> values;
    addValues(layer(l), shiftOf(l), values);
    for (const int value : values) layerOf_.emplace(value, l);
    if (layerOf_.size() > kMaxLabels)
      throw Told<InputError>(Finding(K::tooManyLabels, {{"file", path_}, {"most", kMaxLabels}}));
  }
  if (layerOf_.empty()) throw Told<InputError>(Finding(K::labelsEmpty, {{"file", path_}}));
}

Mask LabelFile::mask(std::optional<int> label) {
  if (info_.layers == 1) return maskOf(read_, label);
  if (label) {
    findLabels();
    const auto at = layerOf_.find(*label);
    if (at == layerOf_.end()) return maskOf(read_, std::nan(""));  // none at all
    return maskOf(layer(at->second), *label - shiftOf(at->second));
  }
  auto any = std::make_shared<std::vector<std::uint8_t>>(info_.grid.voxelCount());
  for (int l = 0; l < info_.layers; ++l)
    visitVoxels(layer(l), [&](const auto* value) {
      for (std::size_t i = 0; i < any->size(); ++i) (*any)[i] |= value[i] != 0 ? 1 : 0;
    });
  return maskOf({info_.grid, VoxelType::uint8, {any, any->data()}}, std::nullopt);
}

std::vector<NamedLabel> LabelFile::labels() {
  findLabels();
  const FileLabels said = labelsSaidBy(path_);
  std::vector<NamedLabel> out;
  for (const auto& [number, layer] : layerOf_) {
    const auto label = said.find(number);
    out.push_back({label == said.end() ? FileLabel() : label->second, number});
  }
  return out;
}

FileLabels labelsSaidBy(const std::string& path) {
  FileLabels labels = readSlicerLabels(path);
  return labels.empty() ? readDicomLabels(path) : labels;
}

std::vector<NamedLabel> labelsIn(const std::string& path) { return LabelFile(path).labels(); }

FileLabel labelIn(const std::string& path, std::optional<int> number) {
  const FileLabels labels = labelsSaidBy(path);
  const auto found = number ? labels.find(*number) : labels.size() == 1 ? labels.begin() : labels.end();
  return found == labels.end() ? FileLabel() : found->second;
}

ObjectLabel asInItsFile(const std::string& path, std::optional<int> number, bool isAnonymous,
                        const ObjectLabel& label) {
  FileLabel said = labelIn(path, number);
  if (isAnonymous) said.name.clear();
  return labelledAs(said, label);
}

int labelCalled(const std::string& path, const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  if (const auto [at, error] = std::from_chars(text.data(), end, number); error == std::errc() && at == end)
    return number;
  const FileLabels labels = labelsSaidBy(path);
  std::vector<int> called;
  for (const auto& [value, label] : labels)
    if (label.name == text) called.push_back(value);
  if (called.size() == 1) return called[0];
  if (called.size() > 1) refuseInput(path, {K::labelsCalledAlike, {{"name", text}}});
  const std::string names = namesIn(labels);
  if (names.empty()) refuseInput(path, {K::noLabelNamed, {{"name", text}}});
  refuseInput(path, {K::noLabelCalled, {{"name", text}, {"names", names}}});
}

}  // namespace handlebody
