#pragma once
// What of a region is wide, in runs of cells along the first axis.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace handlebody {

//! Which cells hang together: those that share a face, or a corner at least.
enum class Touching { faces, corners };

class WideRuns {
 public:
  //! `radius`: per cell, x fastest; 0 in all of the outermost layer. Must outlive this.
  WideRuns(const std::array<int, 3>& size, const std::vector<float>& radius, Touching touching)
      : size_(size), radius_(radius), touching_(touching) {}

  //! True if each part that is at least `width` wide and hangs together holds one of the starts (cells).
  bool allHold(std::span<const std::uint32_t> starts, double width);

 private:
  struct Run {
    std::uint32_t from, to;  // cells, both included
  };

  void find(double width);
  void join();
  void joinRows(std::ptrdiff_t row, std::ptrdiff_t back);
  std::optional<std::uint32_t> runOf(std::uint32_t cell) const;
  std::uint32_t root(std::uint32_t run);

  std::array<int, 3> size_;
  const std::vector<float>& radius_;
  Touching touching_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> firstOfRow_, parent_;
};

}  // namespace handlebody
