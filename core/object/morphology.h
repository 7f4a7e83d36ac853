#pragma once
// Grey-level erosion and dilation of bytes on a grid, for openings.

#include <array>
#include <cstdint>
#include <vector>

namespace handlebody {

//! One pass: the nearest cells along some axes, diagonally within pairs of them as well or not.
struct OpeningPass {
  std::array<bool, 3> along{false, false, false};
  bool diagonal = false;
};

//! Keeps its working memory from pass to pass. Beyond the border the cells are those of the border.
class Morphology {
 public:
  explicit Morphology(const std::array<int, 3>& size) : size_(size) {}
  //! Every cell becomes the highest of its neighbourhood.
  void highest(std::vector<std::uint8_t>& cells, const OpeningPass& pass) { run<true>(cells, pass); }
  //! The lowest.
  void lowest(std::vector<std::uint8_t>& cells, const OpeningPass& pass) { run<false>(cells, pass); }

 private:
  template <bool highest>
  void run(std::vector<std::uint8_t>& cells, const OpeningPass& pass);

  std::array<int, 3> size_;
  std::vector<std::uint8_t> result_, wide_;
};

}  // namespace handlebody
