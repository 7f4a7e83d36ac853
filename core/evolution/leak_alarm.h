#pragma once
// The alarm that a growing surface has come through a passage much narrower than what lies on both sides, or
// out of its space into one much wider.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/evolution/passages.h"
#include "core/finding.h"
#include "core/mesh/mesh.h"

namespace handlebody {

//! A passage that the surface has come through.
struct Leak {
  int iteration = 0;  //!< the first one at which the surface lies behind it
  Passage passage{};
  Vec3 place{0, 0, 0};  //!< mm, LPS: where it is narrowest
  WallDisc disc{};      //!< closes it
};

//! Of what kind the passage is, where it is and how wide (FindingKind::passage, passageTooNarrow).
Finding findingOf(const Leak& leak);
//! "it came through a passage 3.0 mm wide at 50.0,39.5,39.5 from a space 39 mm wide into one 39 mm wide":
//! in English, without a full stop.
inline std::string sentence(const Leak& leak) { return sentence(findingOf(leak)); }

//! Looks at the surface once per iteration. Passages are found in the image (passages.h), in a box around the
//! surface that is widened as it grows, so that a volume that is not reached costs nothing. A passage is told
//! once: also if the surface lies behind it already when the wider box shows it, but not if it did at the
//! first look (a click there, other parameters).
class LeakAlarm {
 public:
  LeakAlarm();

  //! What the surface grows in.
  struct Scene {
    const ObjectImage& image;
    const Walls* walls;           //!< null: none
    std::span<const Vec3> seeds;  //!< mm
    int iteration;
    int threads = 1;
  };
  //! `moving`: the vertices that may have come to lie somewhere else since the last look.
  std::vector<Leak> look(const Mesh& mesh, std::span<const int> moving, const Scene& scene);
  //! The image, the walls or the seeds are others now.
  void forget();
  //! What it goes by; null before the first look.
  const PassageMap* map() const { return map_.get(); }

 private:
  struct Charts;
  struct Entry {
    std::size_t passage;
    int vertex;  // the first that lies behind it
  };
  bool isCovered(const Mesh& mesh, std::span<const int> vertices) const;
  void chart(const Mesh& mesh, const Scene& scene);
  std::vector<Entry> widen(const Mesh& mesh, const Scene& scene);
  void begin(const Mesh& mesh, const Scene& scene);
  void setEntered(std::size_t passage);
  std::vector<Entry> enteredBy(const Mesh& mesh, std::span<const int> vertices);

  Grid grid_;
  VoxelBox box_;  // of the map
  std::shared_ptr<const PassageMap> map_;
  std::vector<bool> entered_;                       // per passage of the map
  std::vector<Vec3> known_;                         // mm: spaces that the surface has come into
  std::vector<Vec3> told_;                          // mm: where it lay when that was told
  std::shared_ptr<const std::vector<Vec3>> first_;  // mm: where its vertices lay at the first look
  //! Of the present image, walls and seeds, shared by all copies: steps that are made again need no new map.
  std::shared_ptr<Charts> charts_;
};

}  // namespace handlebody
