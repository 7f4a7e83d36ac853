#pragma once
// A surface that was grown in one frame is carried through the others: that of each starts the next
// (docs/time.md).

#include <functional>
#include <optional>
#include <vector>

#include "core/evolution/active_contour.h"
#include "core/evolution/grown_under.h"
#include "core/finding.h"
#include "core/mesh/mesh.h"
#include "core/sequence/moved_object.h"
#include "core/volume/volume.h"

namespace handlebody {

//! What went wrong in a frame.
enum class FrameFault {
  unreadable,   //!< its voxels cannot be read
  noObject,     //!< the image shows no object where the surface is
  vanished,     //!< the surface collapsed
  leaked,       //!< it came through a narrow passage (LeakAlarm)
  jumped,       //!< its volume changed by more than a factor from the frame beside it
  changed,      //!< its topology is not that of the first (only where it is free)
  fromFailed,   //!< it was carried from a frame that failed
  otherObject,  //!< the likeliest object there failed; the candidate that is nearest in volume did not
  movedObject,  //!< it is the object of the frame beside it, as the images move it: what clicks mean is
                //!< another
  held,         //!< changes of its topology were held back
  unfinished,   //!< it was still moving at the limit of the iterations, or rests where it would move
};
//! "unreadable", "no-object" … as in the report.
const char* frameFaultName(FrameFault fault);
//! True where the surface of the frame, if there is one, must not be trusted: it starts no other frame.
bool isFailure(FrameFault fault);

struct ToldFault {
  FrameFault fault = FrameFault::unreadable;
  Finding finding;  //!< of the kinds frame…
};
//! That the surface came through a passage.
ToldFault leakFault(const Leak& leak);
//! What is to be told of how a growth ended: what was held back, and that it was moving still at the limit of
//! its iterations, or rests where it would move. Nothing of one that was ended on purpose.
std::vector<ToldFault> faultsAtEnd(StopReason stopped, const std::vector<HeldPlace>& held);

//! What came of one frame.
struct FrameResult {
  int frame = 0;
  std::optional<int> shownIn{};   //!< the frame whose image shows it, if that is another
  std::optional<int> from{};      //!< the frame whose surface it started from; none: grown from the seeds
  TriangleSoup mesh{};            //!< mm LPS: closed, certified; empty: there is none
  double volume = 0;              //!< mm³ enclosed
  int components = 0, genus = 0;  //!< genus: sum over the components
  int iterations = 0;
  StopReason stopped = StopReason::running;
  double seconds = 0;  //!< wall clock, with reading
  std::vector<ToldFault> faults{};
  bool isCorrected = false;            //!< by hand
  GrownUnder under{};                  //!< where there is a mesh: what binds a polish of it
  std::optional<MovedObject> moved{};  //!< what was given as the object; none: what clicks mean was found
  bool isTrusted() const;              //!< none of the faults is a failure, and there is a mesh
  bool startsNext() const;             //!< the same but for what it was carried from
};

//! A frame that was corrected by hand. Its surface starts from that of the frame beside it, as a carried one,
//! and is grown as this says; the frames beyond it, seen from the one that was grown, start from it, with its
//! clicks, walls and limits.
struct FrameCorrection {
  int frame = 0;
  Request request;                         //!< at the beginning
  std::vector<ParameterChange> changes{};  //!< on the way, in ascending order
  std::optional<int> stopAt{};             //!< the iteration whose surface is meant; none: the last
  //! Its object is that of the frame beside it, as the images move it, made anew whenever it is carried:
  //! neither the request nor a change holds it.
  bool isOfMoved = false;
  bool operator==(const FrameCorrection& other) const;
};

//! What the clicks, walls and limits of a correction are in the end.
Request finalRequest(const FrameCorrection& correction);

//! With what its object is, at all iterations.
FrameCorrection withObject(FrameCorrection correction, const StartSurface& object);

//! What is carried, and how.
struct OverTimeSettings {
  Request request;                             //!< of the frame that was grown, as it was in the end
  double edgeLength = 1;                       //!< mm, as used there
  double smoothing = 0;                        //!< the same
  bool holdTopology = true;                    //!< else it may change from frame to frame
  int grownFrame = 0;                          //!< in which `request` was grown
  std::vector<FrameCorrection> corrections{};  //!< at most one of a frame
};

//! What is asked for in a frame that is carried to, with the edge length and smoothing of the frame that was
//! grown: nothing of it names an iteration. With a moved object where one is given.
Request carriedRequest(const OverTimeSettings& settings, int frame,
                       const std::optional<MovedObject>& moved = {});

//! A volume that may differ from that of the frame beside it by this factor, either way, is no jump; per
//! frame between the two. The fastest phase of a heart with an ejection fraction of 70 % in 20 frames changes
//! it by a third.
inline constexpr double kJump = 2;

//! Carries surfaces from frame to frame.
class FrameCarrier {
 public:
  //! `load` gives the voxels of a frame; it throws InputError where it cannot. `finish` makes the mesh that
  //! counts of one that was grown (rounding, certificate), and gives its volume.
  struct Hooks {
    std::function<Volume(int frame)> load;
    std::function<TriangleSoup(const TriangleSoup&)> finish;
  };
  FrameCarrier(OverTimeSettings settings, Hooks hooks);

  //! From the surface of `from`, which is trusted, onto another frame. The surface moves in both directions
  //! through the steps of ActiveContour, in the image of that frame alone; walls and limits of the topology
  //! stay, vetoes, pins and edits do not: they name an iteration. Where that fails, once more with the
  //! candidate whose volume is nearest to that of `from`. The object of `from`, as the two images move it
  //! (FrameMotion), is taken where that fails as well but the image shows the moved one, and where the choice
  //! is close and what was found agrees too little with it. Faults are told in the result. Throws what is no
  //! fault of the frame: Cancelled, std::runtime_error of `finish`.
  FrameResult carry(const FrameResult& from, int frame) const;

 private:
  const FrameCorrection* correctionOf(int from, int frame) const;
  FrameResult corrected(const FrameCorrection& asked, const FrameResult& from) const;
  //! What the clicks mean in a frame, as far as it was looked for.
  struct Meant {
    std::vector<ObjectCandidate> candidates{};
    bool isCloseChoice = false;
  };
  //! The same with one of the objects that the clicks may mean there.
  FrameResult attempt(const FrameResult& from, int frame, const Volume& volume, int candidate,
                      Meant& meant) const;
  //! The same with a moved object. If it must be shown it is not trusted where the image shows no edge at
  //! most of the surface.
  FrameResult attemptMoved(const FrameResult& from, int frame, const Volume& volume, const MovedObject& moved,
                           bool mustBeShown) const;
  MovedObject movedFrom(const FrameResult& from, const Volume& volume) const;
  FrameResult foundAnew(const FrameResult& from, int frame, const Volume& volume, Meant& meant) const;
  FrameResult tried(const FrameResult& from, int frame) const;
  void grow(ActiveContour& contour, const FrameResult& from, FrameResult& result) const;
  void judge(const FrameResult& from, const ActiveContour& contour, FrameResult& result) const;

  OverTimeSettings settings_;
  Hooks hooks_;
};

//! Carries `start` to `last` frame by frame, up or down, without start's own. A frame that fails starts no
//! other: the one behind it starts from the last one that did not. If `start` itself failed all are made, and
//! none is trusted. `told` is called with each.
std::vector<FrameResult> carryThrough(const FrameCarrier& carrier, const FrameResult& start, int last,
                                      const std::function<void(const FrameResult&)>& told = {});

}  // namespace handlebody
