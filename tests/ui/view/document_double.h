#pragma once
// A Document without files, threads and growth, for tests of the views: it keeps what it is given and tells
// it.

#include <memory>
#include <string>
#include <vector>

#include "ui/model/document.h"

namespace handlebody::ui::testing {

//! As if the volume had just been opened.
void setVolume(Document& document, const Volume& volume);
//! `certified`: it bounds a body.
void setSnapshot(Document& document, const TriangleSoup& mesh, const std::vector<FaceState>& states = {},
                 const SurfaceSupport& support = {}, bool certified = false);
//! As if what was given last had never been compared with the image.
void forgetSupport(Document& document);
//! As if another time point were shown.
void setFrame(Document& document, const Volume& volume);
//! As if a frame were shown that the surface was carried to with these walls.
void showCarried(Document& document, const WallList& walls);
//! As if the shown surface were out of date.
void setOutOfDate(Document& document, bool isOutOfDate);
//! Of the active object.
void setVisible(Document& document, bool isVisible);
//! Objects besides the active one.
void setOthers(Document& document, const std::vector<ObjectInfo>& others);
void setGrowthState(Document& document, GrowthState growth);
void setConstraints(Document& document, const Constraints& constraints);
//! The last stroke of the brush, and of the eraser.
const std::vector<WallBall>& painted(const Document& document);
const std::vector<WallBall>& erased(const Document& document);
//! The last strokes over the surface.
const std::vector<WallBall>& pinned(const Document& document);
const std::vector<WallBall>& unpinned(const Document& document);
//! All that were asked for.
const std::vector<MeshEdit>& edits(const Document& document);
//! The gestures of all calls that moved or sized a seed.
const std::vector<int>& gestures(const Document& document);

}  // namespace handlebody::ui::testing
