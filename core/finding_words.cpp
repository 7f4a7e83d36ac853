// The names and the English words of findings: of all that the engine has to tell, nothing else in it is
// words. The window translates them, or has words of its own where these name an option.

#include "core/finding_words.h"

#include <algorithm>
#include <array>

// What lupdate looks for; Qt itself is not needed. Not marked: what the window has words of its own for
// (ui/model/finding_text.cpp).
#define QT_TRANSLATE_NOOP(context, text) text

namespace handlebody {

namespace {

using K = FindingKind;

constexpr FindingWords kWords[] = {
    {K::none, "none", ""},
    {K::other, "other", "{text}"},
    {K::heldAtNeck, "held-at-neck",
     "the surface is held at a neck of radius {radius_mm:3g} mm: behind it the same "
     "intensities go on for at least {behind_ml:3g} ml, in front of it they fill "
     "{in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or give "
     "{option:range}, which holds nothing back"},
    {K::heldAtHole, "held-at-hole",
     "the surface is held at a hole of radius {radius_mm:3g} mm in a thin wall: behind it "
     "the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill "
     "{in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or give "
     "{option:range}, which holds nothing back"},
    {K::heldWhereItWidens, "held-where-it-widens",
     "the surface is held where its structure grows wider than a radius of {radius_mm:3g} "
     "mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of "
     "it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there "
     "too, or give {option:range}, which holds nothing back"},
    {K::noEdge, "no-edge",
     QT_TRANSLATE_NOOP("Findings",
                       "{percent:0f} % of the surface lies where the image shows no edge: the object may go "
                       "on there, or the surface leaked")},
    {K::atVolumeBorder, "at-volume-border",
     QT_TRANSLATE_NOOP("Findings",
                       "{percent:0f} % of the surface lies on the border of the volume: the object is cut "
                       "off there, or the surface leaked")},
    {K::atViewBorder, "at-view-border",
     QT_TRANSLATE_NOOP("Findings",
                       "{percent:0f} % of the surface lies on the border of the field of view: the object is "
                       "cut off there, or the surface leaked")},
    {K::liesInWall, "lies-in-wall",
     QT_TRANSLATE_NOOP("Findings", "the surface still lies in a wall that was put over it")},
    {K::nothingAllowed, "nothing-allowed",
     QT_TRANSLATE_NOOP("Findings",
                       "at the allowed place {place} nothing came that a limit of the topology would have "
                       "held")},
    {K::heldAtPassages, "held-at-passages",
     QT_TRANSLATE_NOOP("Findings",
                       "the surface is held at passages narrower than a radius of {radius_mm:3g} mm; where "
                       "what lies behind them belongs to the object, put a seed there too, or take a larger "
                       "candidate")},
    {K::endsWithSearch, "ends-with-search",
     QT_TRANSLATE_NOOP(
         "Findings",
         "the object reaches the end of what was searched around the seed and is cut off there; "
         "where it goes on, put a seed there too")},
    {K::stuck, "stuck",
     "the surface got stuck: no part of a step could be kept, again and again (see the "
     "rolled back events of the report); another {option:edge-length} may help"},
    {K::frozen, "frozen",
     "the surface rests at places that would still move, because changes there failed or "
     "repeated again and again (see the rolled back events of the report); another "
     "{option:edge-length} or {option:smoothing} may help"},
    {K::hardlyGrown, "hardly-grown",
     "the surface hardly grew beyond its seed: look at {option:object} and {option:range}"},
    {K::heldByCurvature, "held-by-curvature",
     "the surface hardly grew beyond its seed: {option:curvature} holds every front of a radius "
     "below {radius_mm:3g} mm, and the seed is smaller; give it a larger radius, or lower "
     "{option:curvature}"},
    {K::closeChoice, "close-choice",
     "the choice among {objects} objects is close (expected overlap with the one that is "
     "meant: Dice {dice:2g}): the next candidate holds {next_ml:3m} ml where this one "
     "holds {this_ml:3m} ml; see {option:candidate}"},
    {K::leaked, "leaked",
     "the surface leaked at iteration {iteration}: {cause}; {option:wall-disc} {disc} closes the "
     "passage"},
    {K::leakWalled, "leak-walled",
     "the surface leaked at iteration {iteration}: {cause}; a wall was put there "
     "({option:wall-disc} {disc})"},
    {K::leakStopped, "leak-stopped",
     "the surface leaked at iteration {iteration}: {cause}; the mesh is that of iteration "
     "{mesh_iteration}, before it came there; {option:wall-disc} {disc} closes the passage"},
    {K::passage, "passage",
     QT_TRANSLATE_NOOP("Findings",
                       "it came through a passage {width_mm:1f} mm wide at {place:1f} from a space "
                       "{before_mm:0f} mm wide into one {behind_mm:0f} mm wide")},
    {K::passageTooNarrow, "passage-too-narrow",
     QT_TRANSLATE_NOOP("Findings",
                       "it came through a passage too narrow for the voxels to show at {place:1f} from a "
                       "space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide")},
    {K::pinNotReached, "pin-not-reached",
     QT_TRANSLATE_NOOP("Findings",
                       "the pin {pin} holds nothing: the mesh is that of iteration {mesh_iteration}, and its "
                       "iteration never came")},
    {K::vetoNotReached, "veto-not-reached",
     QT_TRANSLATE_NOOP("Findings",
                       "the veto of iteration {iteration:0f} forbids nothing: the mesh is that of iteration "
                       "{mesh_iteration:0f}")},
    {K::editNotReached, "edit-not-reached",
     QT_TRANSLATE_NOOP("Findings",
                       "the edit of iteration {iteration:0f} is not made: the mesh is that of iteration "
                       "{mesh_iteration:0f}")},
    {K::undecided, "undecided",
     "at iteration {iteration} a limit of the topology holds: {cause}; {option:allow}={spot} lets it happen, "
     "{option:hold}={spot} holds it without asking again"},
    {K::wouldEnclose, "would-enclose",
     QT_TRANSLATE_NOOP("Findings", "it would enclose a cavity of {ml:3g} ml at {place:1f}")},
    {K::wouldComeOff, "would-come-off",
     QT_TRANSLATE_NOOP("Findings", "a part of {ml:3g} ml would come off at {place:1f}")},
    {K::frontsWouldMeet, "fronts-would-meet",
     QT_TRANSLATE_NOOP("Findings", "its fronts would meet at {place:1f}")},
    {K::wouldMakeTunnel, "would-make-tunnel",
     QT_TRANSLATE_NOOP("Findings",
                       "its fronts would meet at {place:1f} and make a tunnel {around_mm:3g} mm around")},
    {K::wouldChange, "would-change",
     QT_TRANSLATE_NOOP("Findings", "a change of its topology ({event}) would happen at {place:1f}")},
    {K::runsWithoutSurface, "runs-without-surface",
     QT_TRANSLATE_NOOP("Findings",
                       "With clicks, smoothing and noise a little different, {runs} of {of} runs leave no "
                       "surface")},
    {K::otherTopology, "other-topology",
     QT_TRANSLATE_NOOP("Findings",
                       "With clicks, smoothing and noise a little different, {runs} of {of} runs have "
                       "another topology")},
    {K::volumeVaries, "volume-varies",
     QT_TRANSLATE_NOOP("Findings",
                       "The volume depends on where exactly is clicked, on smoothing or noise: it changes by "
                       "{percent:0f} %")},
    {K::volumeBesideRuns, "volume-beside-runs",
     QT_TRANSLATE_NOOP(
         "Findings",
         "The volume of the surface, {volume_ml:4g} ml, lies outside of those of all runs with "
         "clicks, smoothing and noise a little different, {least_ml:4g} to {most_ml:4g} ml: they "
         "may have found another object")},
    {K::polishLeaves, "polish-leaves", "{text}"},
    {K::givenWithThin, "given-with-thin",
     QT_TRANSLATE_NOOP("Findings",
                       "the mesh is written as it was given: triangles with an angle under 15 degrees: "
                       "{thin_faces:0f}, edges whose faces meet at less than 20 degrees: {sharp_edges:0f} "
                       "(handlebody-cli edit --polish all betters them)")},
    {K::givenShares, "given-shares",
     QT_TRANSLATE_NOOP("Findings",
                       "labels of the map that was given overlap: {voxels:0f} voxels of this one are left to "
                       "smaller ones that hold them, too")},
    {K::madeWithEarlier, "made-with-earlier",
     QT_TRANSLATE_NOOP("Findings",
                       "The surface was made with an earlier one of the object '{object}', and a replay may "
                       "make another")},

    {K::seedNotEnclosed, "seed-not-enclosed",
     QT_TRANSLATE_NOOP(
         "Findings",
         "the surface does not enclose the seed at {place:1f} mm, which lies {distance_mm:1f} mm "
         "outside of it: the image or other clicks speak against it")},
    {K::clickEnclosed, "click-enclosed",
     QT_TRANSLATE_NOOP("Findings",
                       "the surface encloses the click outside of the object at {place:1f} mm, which lies "
                       "{distance_mm:1f} mm within it: the image or other clicks speak against it")},
    {K::ballEntered, "ball-entered",
     QT_TRANSLATE_NOOP(
         "Findings",
         "the surface reaches {distance_mm:1f} mm into the ball of {radius_mm:1f} mm around the "
         "click outside of the object at {place:1f} mm: the image or other clicks speak "
         "against it")},

    {K::keptApart, "kept-apart", QT_TRANSLATE_NOOP("Findings", "kept apart here, as asked")},
    {K::overLimit, "over-limit",
     QT_TRANSLATE_NOOP("Findings", "held: it would break the limit of the topology")},
    {K::changesAgain, "changes-again",
     QT_TRANSLATE_NOOP("Findings", "the same place changed again and again, and rests from now on")},
    {K::nothingKept, "nothing-kept", QT_TRANSLATE_NOOP("Findings", "no part of the step could be kept")},
    {K::frontsNotJoined, "fronts-not-joined",
     QT_TRANSLATE_NOOP("Findings", "{fronts} fronts could not be joined at once: {cause}")},
    {K::frontsWait, "fronts-wait",
     QT_TRANSLATE_NOOP("Findings", "of {fronts} fronts {left} left for the next round")},
    {K::ringAdded, "ring-added", QT_TRANSLATE_NOOP("Findings", "1 ring added: {cause}")},
    {K::ringsAdded, "rings-added", QT_TRANSLATE_NOOP("Findings", "{rings} rings added: {cause}")},
    {K::maybeShorter, "maybe-shorter", QT_TRANSLATE_NOOP("Findings", "there may be a shorter handle")},
    {K::meetsPinned, "meets-pinned",
     QT_TRANSLATE_NOOP("Findings", "the surface came to a pinned part, and stops before it")},
    {K::tooMuchWork, "too-much-work",
     QT_TRANSLATE_NOOP("Findings", "to close the place would take too much work")},
    {K::workIsDone, "work-is-done",
     QT_TRANSLATE_NOOP("Findings", "the work that a step may take is done: the place waits")},
    {K::meetInside, "meet-inside",
     QT_TRANSLATE_NOOP("Findings", "the fronts meet through the inside of the object")},
    {K::noHandle, "no-handle", QT_TRANSLATE_NOOP("Findings", "no handle fits")},
    {K::noPatch, "no-patch", QT_TRANSLATE_NOOP("Findings", "no patch fits")},
    {K::enclosesForbidden, "encloses-forbidden",
     QT_TRANSLATE_NOOP("Findings", "the component encloses a place where no surface may go")},
    {K::openingTooLarge, "opening-too-large", QT_TRANSLATE_NOOP("Findings", "the opening is too large")},
    {K::pinnedThere, "pinned-there", QT_TRANSLATE_NOOP("Findings", "a pinned part lies there")},
    {K::nothingLeft, "nothing-left", QT_TRANSLATE_NOOP("Findings", "nothing of the component would be left")},
    {K::entersWall, "enters-wall", QT_TRANSLATE_NOOP("Findings", "the surface would have entered a wall")},
    {K::unseenChange, "unseen-change",
     QT_TRANSLATE_NOOP("Findings", "a part of the surface has changed that detection had not looked at")},
    {K::eventsDisagree, "events-disagree",
     QT_TRANSLATE_NOOP("Findings", "the events of the step do not follow from each other")},
    {K::otherEuler, "other-euler",
     QT_TRANSLATE_NOOP("Findings", "the Euler number is not the one that the events predict")},
    {K::otherComponents, "other-components",
     QT_TRANSLATE_NOOP("Findings", "the components are not those that the events predict")},
    {K::cavityOutside, "cavity-outside", QT_TRANSLATE_NOOP("Findings", "a cavity lies outside of any body")},
    {K::bodyInBody, "body-in-body", QT_TRANSLATE_NOOP("Findings", "a body lies directly in another")},
    {K::stillIntersects, "still-intersects",
     QT_TRANSLATE_NOOP("Findings", "the surface still intersected itself after several changes")},
    {K::enclosesNothing, "encloses-nothing",
     QT_TRANSLATE_NOOP("Findings", "the surface does not enclose a volume")},
    {K::closesOverPinned, "closes-over-pinned",
     QT_TRANSLATE_NOOP("Findings", "the surface would close over a pinned part, and stops before it")},
    {K::pinnedWouldChange, "pinned-would-change",
     QT_TRANSLATE_NOOP("Findings", "a pinned part would have changed")},
    {K::editIntoWall, "edit-into-wall",
     QT_TRANSLATE_NOOP("Findings", "the surface would come into a wall or around it")},
    {K::editOfPinned, "edit-of-pinned", QT_TRANSLATE_NOOP("Findings", "a pinned part would change")},
    {K::tooManyComponents, "too-many-components",
     QT_TRANSLATE_NOOP("Findings", "there would be more components than may be")},
    {K::tooManyTunnels, "too-many-tunnels",
     QT_TRANSLATE_NOOP("Findings", "there would be more tunnels than may be")},
    {K::edgeWithOneFace, "edge-with-one-face", QT_TRANSLATE_NOOP("Findings", "an edge has only one face")},
    {K::facesDisagree, "faces-disagree",
     QT_TRANSLATE_NOOP("Findings", "two faces disagree about their common edge")},
    {K::facesOpposed, "faces-opposed",
     QT_TRANSLATE_NOOP("Findings", "the two faces of an edge run in the same direction or have other ends")},
    {K::facesTwice, "faces-twice", QT_TRANSLATE_NOOP("Findings", "two faces have the same three vertices")},
    {K::removedVertex, "removed-vertex",
     QT_TRANSLATE_NOOP("Findings", "a face has a vertex that was removed")},
    {K::vertexTwice, "vertex-twice", QT_TRANSLATE_NOOP("Findings", "a face has a vertex twice")},
    {K::vertexWithoutFace, "vertex-without-face", QT_TRANSLATE_NOOP("Findings", "a vertex has no face")},
    {K::wrongHalfedge, "wrong-half-edge",
     QT_TRANSLATE_NOOP("Findings", "a vertex names a half-edge that does not leave it")},
    {K::edgesTwice, "edges-twice", QT_TRANSLATE_NOOP("Findings", "two edges join the same two vertices")},
    {K::severalFans, "several-fans",
     QT_TRANSLATE_NOOP("Findings", "the faces around a vertex form more than one fan")},
    {K::wrongCounts, "wrong-counts",
     QT_TRANSLATE_NOOP("Findings", "the counts of the mesh are not those of its elements")},

    {K::noVertexInBall, "no-vertex-in-ball",
     QT_TRANSLATE_NOOP("Findings", "no vertex of the surface lies in the ball")},
    {K::planeMisses, "plane-misses", QT_TRANSLATE_NOOP("Findings", "the plane does not meet the surface")},
    {K::planeMissesNear, "plane-misses-near",
     QT_TRANSLATE_NOOP("Findings", "the plane does not meet the surface near that place")},
    {K::noFlatCap, "no-flat-cap", QT_TRANSLATE_NOOP("Findings", "no flat cap fits the cut")},
    {K::cutPartsNothing, "cut-parts-nothing",
     QT_TRANSLATE_NOOP("Findings", "the cut does not part the body there: both of its sides hang together")},
    {K::pullTooFar, "pull-too-far", QT_TRANSLATE_NOOP("Findings", "the pull goes too far for its radius")},
    {K::nothingWouldBeLeft, "nothing-would-be-left",
     QT_TRANSLATE_NOOP("Findings", "nothing of the surface would be left")},
    {K::meetsItself, "meets-itself", QT_TRANSLATE_NOOP("Findings", "the surface would meet itself there")},

    {K::noSeed, "no-seed", QT_TRANSLATE_NOOP("Findings", "No seed was given: at least one is needed.")},
    {K::seedRadius, "seed-radius",
     QT_TRANSLATE_NOOP("Findings", "The radius of a seed must be a number of mm above 0.")},
    {K::seedOutside, "seed-outside",
     "The seed at ({place: 6f}) mm lies outside the volume (voxel {voxel: 6f})."},
    {K::clickOutside, "click-outside",
     "The click outside of the object at ({place: 6f}) mm lies outside the volume."},
    {K::clicksContradict, "clicks-contradict",
     QT_TRANSLATE_NOOP("Findings",
                       "The seed at {place:1f} mm and the click outside of the object at {outside:1f} mm "
                       "contradict each other: both lie in one voxel.")},
    {K::ballOverSeed, "ball-over-seed",
     QT_TRANSLATE_NOOP("Findings",
                       "The seed at {place:1f} mm lies in the ball of {radius_mm:1f} mm around the click "
                       "outside of the object at {outside:1f} mm: they contradict each other.")},
    {K::clickOverStart, "click-over-start",
     QT_TRANSLATE_NOOP(
         "Findings",
         "The click outside of the object at {outside:1f} mm holds the deepest place of the "
         "surface to begin with, which stands for the object: give a seed, or another surface.")},
    {K::seedNotInRange, "seed-not-in-range",
     "The seed at ({place: 6f}) mm is not in the object: the smoothed intensity there is "
     "{intensity:6f}, the object's range is {low:6f} to {high:6f}."},
    {K::noDarkObject, "no-dark-object",
     QT_TRANSLATE_NOOP("Findings",
                       "The seed is not in a dark object: the image has no clear boundary of that kind "
                       "around it.")},
    {K::noBrightObject, "no-bright-object",
     QT_TRANSLATE_NOOP("Findings",
                       "The seed is not in a bright object: the image has no clear boundary of that kind "
                       "around it.")},
    {K::noObject, "no-object",
     QT_TRANSLATE_NOOP("Findings",
                       "The seed is not in a dark or bright object: the image has no clear boundary of that "
                       "kind around it.")},
    {K::fillsView, "fills-view",
     "The seed is not in an object with a boundary of its own: what grows from it fills "
     "the field of view, up to the padding around the image. Where that is meant, say "
     "whether it is dark or bright, or give {option:range}."},
    {K::rangeEmpty, "range-empty",
     QT_TRANSLATE_NOOP("Findings", "The range is empty: its lower end is above its upper end.")},
    {K::rangeWithoutVoxels, "range-without-voxels",
     "The range {low:6f} to {high:6f} holds no voxel of the volume, whose values run from "
     "{least:6f} to {most:6f}."},
    {K::rangeAndBackground, "range-and-background",
     QT_TRANSLATE_NOOP("Findings",
                       "Clicks outside of the object and a given range do not go together: the range alone "
                       "says where the object ends.")},
    {K::edgeTooShort, "edge-too-short",
     QT_TRANSLATE_NOOP("Findings",
                       "The edge length of {edge_mm} mm is too short for the seeds: their surface alone "
                       "would have over two million triangles.")},
    {K::seedInObject, "seed-in-object",
     QT_TRANSLATE_NOOP("Findings",
                       "The seed at {place} mm lies in the object '{object}', which is done already.")},
    {K::wallOverSeed, "wall-over-seed",
     QT_TRANSLATE_NOOP("Findings", "A wall lies over the seed at {place} mm.")},
    {K::wallLeavesNoRoom, "wall-leaves-no-room",
     QT_TRANSLATE_NOOP("Findings", "A wall leaves the seed at {place} mm no room.")},
    {K::wallWithin, "wall-within",
     QT_TRANSLATE_NOOP("Findings",
                       "The wall at {place} mm lies within the surface, which cannot be pushed out of it: "
                       "go back to before it came in there.")},
    {K::wallAcross, "wall-across",
     QT_TRANSLATE_NOOP("Findings",
                       "The wall at {place} mm lies across surface that is already there: go back to before "
                       "it came in there.")},
    {K::wallOver, "wall-over",
     QT_TRANSLATE_NOOP("Findings",
                       "The wall at {place} mm lies over surface that is already there: go back to before it "
                       "came in there, or let the surface move in both directions.")},
    {K::objectOver, "object-over",
     QT_TRANSLATE_NOOP("Findings",
                       "The object '{object}' lies over surface that is already there: go back to before it "
                       "came in there.")},
    {K::clicksVersusPins, "clicks-versus-pins",
     QT_TRANSLATE_NOOP("Findings",
                       "The clicks have so little in common with the surface that it would begin anew, but a "
                       "part of it is pinned: take the pins away first.")},
    {K::vetoTooLate, "veto-too-late",
     QT_TRANSLATE_NOOP("Findings",
                       "The veto of iteration {iteration} comes too late: the surface is at iteration "
                       "{now}.")},
    {K::vetoFindsNothing, "veto-finds-nothing",
     QT_TRANSLATE_NOOP("Findings",
                       "The veto of iteration {iteration} has nothing to forbid: no change of topology "
                       "happens there.")},
    {K::pinTooLate, "pin-too-late",
     QT_TRANSLATE_NOOP("Findings", "The pin {pin} comes too late: the surface is at iteration {now}.")},
    {K::pinHoldsNothing, "pin-holds-nothing",
     QT_TRANSLATE_NOOP("Findings",
                       "The pin {pin} holds nothing: no vertex of the surface lies there at iteration "
                       "{now}.")},
    {K::editTooLate, "edit-too-late",
     QT_TRANSLATE_NOOP("Findings",
                       "The edit of iteration {iteration} comes too late: the surface is at iteration "
                       "{now}.")},
    {K::editRefused, "edit-refused",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration} cannot be made: {cause}.")},
    {K::editFindsNoTunnel, "edit-finds-no-tunnel",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration} finds no tunnel at {place}.")},
    {K::editFindsNoComponent, "edit-finds-no-component",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration} finds no component at {place}.")},
    {K::editFindsNoCavity, "edit-finds-no-cavity",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration} finds no cavity at {place}.")},
    {K::editWithoutCap, "edit-without-cap",
     QT_TRANSLATE_NOOP("Findings",
                       "The edit of iteration {iteration} cannot be made: no cap fits into the tunnel at "
                       "{place}.")},
    {K::editRemovesNothing, "edit-removes-nothing",
     QT_TRANSLATE_NOOP("Findings",
                       "The edit of iteration {iteration} finds nothing to remove: there is nothing beside "
                       "that component.")},
    {K::editLeavesNothing, "edit-leaves-nothing",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration} would leave nothing of the surface.")},
    {K::surfaceVanished, "surface-vanished",
     QT_TRANSLATE_NOOP("Findings",
                       "The surface vanished after {iterations} iterations: the seeds are not in an object "
                       "of that kind and range.")},

    {K::frameUnreadable, "frame-unreadable", "{cause}"},
    {K::frameNotRead, "frame-not-read", QT_TRANSLATE_NOOP("Findings", "its voxels cannot be read")},
    {K::frameNoObject, "frame-no-object", "{cause}"},
    {K::frameVanished, "frame-vanished", QT_TRANSLATE_NOOP("Findings", "the surface vanished")},
    {K::frameLeaked, "frame-leaked", QT_TRANSLATE_NOOP("Findings", "the surface leaked: {cause}")},
    {K::frameJumped, "frame-jumped",
     QT_TRANSLATE_NOOP("Findings",
                       "the volume jumps from {from_ml:4g} ml in frame {from_frame} to {to_ml:4g} ml")},
    {K::frameGenusChanged, "frame-genus-changed",
     QT_TRANSLATE_NOOP("Findings",
                       "the topology changes from 1 component of genus {genus_before} to 1 component of "
                       "genus {genus}")},
    {K::frameCameApart, "frame-came-apart",
     QT_TRANSLATE_NOOP("Findings",
                       "the topology changes from 1 component of genus {genus_before} to {components} "
                       "components of genus {genus}")},
    {K::frameCameTogether, "frame-came-together",
     QT_TRANSLATE_NOOP("Findings",
                       "the topology changes from {components_before} components of genus {genus_before} to "
                       "1 component of genus {genus}")},
    {K::frameTopologyChanged, "frame-topology-changed",
     QT_TRANSLATE_NOOP("Findings",
                       "the topology changes from {components_before} components of genus {genus_before} to "
                       "{components} components of genus {genus}")},
    {K::frameHeldAtPlace, "frame-held-at-place",
     QT_TRANSLATE_NOOP("Findings", "the topology was held at 1 place, the first at {place} mm")},
    {K::frameHeldAtPlaces, "frame-held-at-places",
     QT_TRANSLATE_NOOP("Findings", "the topology was held at {places} places, the first at {place} mm")},
    {K::frameOtherObject, "frame-other-object",
     QT_TRANSLATE_NOOP("Findings",
                       "another object is likelier there, but it fails ({cause}); candidate {candidate} was "
                       "taken")},
    {K::frameMovedObject, "frame-moved-object",
     QT_TRANSLATE_NOOP("Findings",
                       "what the clicks mean there agrees to {percent:0f} % (Dice) with the object of frame "
                       "{from_frame} as the images move it; the latter was taken")},
    {K::frameMovedInstead, "frame-moved-instead",
     QT_TRANSLATE_NOOP("Findings",
                       "what the clicks mean there fails ({cause}); the object of frame {from_frame} as the "
                       "images move it was taken")},
    {K::frameFromFailed, "frame-from-failed",
     QT_TRANSLATE_NOOP("Findings", "it was carried from frame {from_frame}, whose surface failed")},
    {K::frameAtLimit, "frame-at-limit", "the surface was not at rest of its own accord (max-iterations)"},
    {K::frameStuck, "frame-stuck", "the surface was not at rest of its own accord (stuck)"},
    {K::frameFrozen, "frame-frozen", "the surface was not at rest of its own accord (frozen)"},

    {K::balloonNotPositive, "balloon-not-positive",
     QT_TRANSLATE_NOOP("Findings", "The balloon weight must be a number above 0.")},
    {K::curvatureNegative, "curvature-negative",
     QT_TRANSLATE_NOOP("Findings", "The curvature weight must be a number of at least 0.")},
    {K::iterationsNegative, "iterations-negative",
     QT_TRANSLATE_NOOP("Findings", "The number of iterations must not be negative.")},
    {K::threadsOutside, "threads-outside",
     QT_TRANSLATE_NOOP("Findings", "The number of threads must be between 0 and 1024.")},
    {K::smoothingNegative, "smoothing-negative",
     QT_TRANSLATE_NOOP("Findings", "The smoothing must be at least 0 mm.")},
    {K::edgeNotPositive, "edge-not-positive",
     QT_TRANSLATE_NOOP("Findings", "The edge length must be above 0 mm.")},
    {K::smoothingTooLarge, "smoothing-too-large",
     QT_TRANSLATE_NOOP("Findings",
                       "The smoothing of {given_mm} mm is too large for a volume whose longest side is "
                       "{longest_mm} mm: at most {most_mm} mm.")},
    {K::edgeTooLarge, "edge-too-large",
     QT_TRANSLATE_NOOP("Findings",
                       "The edge length of {given_mm} mm is too large for a volume whose longest side is "
                       "{longest_mm} mm: at most {most_mm} mm.")},
    {K::componentsTooFew, "components-too-few",
     QT_TRANSLATE_NOOP("Findings", "The number of components must be at least 1.")},
    {K::genusNegative, "genus-negative", QT_TRANSLATE_NOOP("Findings", "The genus must be at least 0.")},
    {K::wallWithoutRadius, "wall-without-radius",
     QT_TRANSLATE_NOOP("Findings", "The wall at {place} has no radius above 0 mm.")},
    {K::wallDiscWithoutRadius, "wall-disc-without-radius",
     QT_TRANSLATE_NOOP("Findings", "The wall disc at {place} has no radius above 0 mm.")},
    {K::wallDiscWithoutNormal, "wall-disc-without-normal",
     QT_TRANSLATE_NOOP("Findings", "The wall disc at {place} mm has a normal of no length.")},
    {K::wallMapNotRead, "wall-map-not-read",
     QT_TRANSLATE_NOOP("Findings", "The label map of the walls has not been read.")},
    {K::startNotRead, "start-not-read",
     QT_TRANSLATE_NOOP("Findings", "The surface to begin with, {file}, has not been read.")},
    {K::vetoWithoutPlace, "veto-without-place",
     QT_TRANSLATE_NOOP("Findings", "A veto needs an iteration of at least 1 and a place.")},
    {K::vetoOfEdit, "veto-of-edit",
     QT_TRANSLATE_NOOP("Findings",
                       "Iteration {iteration:0f} is an edit: there is nothing that a veto could forbid.")},
    {K::pinWithoutRadius, "pin-without-radius",
     QT_TRANSLATE_NOOP("Findings", "The pin at {place} has no radius above 0 mm.")},
    {K::pinIterationNegative, "pin-iteration-negative",
     QT_TRANSLATE_NOOP("Findings", "The pin at {place} mm has an iteration below 0.")},
    {K::editWithoutPlace, "edit-without-place",
     QT_TRANSLATE_NOOP("Findings", "An edit needs an iteration of at least 1 and a place.")},
    {K::editNotFinite, "edit-not-finite",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration:0f} has a number that is not finite.")},
    {K::editWithoutRadius, "edit-without-radius",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration:0f} has no radius above 0 mm.")},
    {K::editRadiusNegative, "edit-radius-negative",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration:0f} has a radius below 0 mm.")},
    {K::editWithoutNormal, "edit-without-normal",
     QT_TRANSLATE_NOOP("Findings", "The edit of iteration {iteration:0f} has a normal of no length.")},
    {K::editTwice, "edit-twice",
     QT_TRANSLATE_NOOP("Findings",
                       "There are two edits of iteration {iteration:0f}: a step can be one only.")},

    {K::vetoLeftOver, "veto-left-over",
     QT_TRANSLATE_NOOP("Findings",
                       "The veto of iteration {iteration:0f} has nothing to forbid: the growth ended at "
                       "iteration {now:0f}.")},
    {K::pinLeftOver, "pin-left-over",
     QT_TRANSLATE_NOOP("Findings", "The pin {pin} holds nothing: the growth ended at iteration {now:0f}.")},
    {K::editLeftOver, "edit-left-over",
     QT_TRANSLATE_NOOP(
         "Findings",
         "The edit of iteration {iteration:0f} is never made: the growth ended at iteration {now:0f}.")},
    {K::surfaceTooFar, "surface-too-far",
     QT_TRANSLATE_NOOP(
         "Findings",
         "The surface intersects itself in single precision: the volume lies too far from the origin.")},
    {K::tooManySamples, "too-many-samples",
     QT_TRANSLATE_NOOP(
         "Findings",
         "{sampling_mm:4g} mm between samples would take more than {most:0f} samples of these surfaces.")},
};

std::array<std::span<const FindingWords>, 4> tables() {
  return {kWords, wordsOfFiles(), wordsOfDicom(), wordsOfWarnings()};
}

const FindingWords& wordsOf(FindingKind kind) {
  for (const auto table : tables()) {
    const auto at = std::ranges::find(table, kind, &FindingWords::kind);
    if (at != table.end()) return *at;
  }
  return kWords[0];
}

}  // namespace

const char* findingName(FindingKind kind) { return wordsOf(kind).name; }

FindingKind findingKindOf(std::string_view name) {
  for (const auto table : tables()) {
    const auto at = std::ranges::find(table, name, &FindingWords::name);
    if (at != table.end()) return at->kind;
  }
  return K::none;
}

const char* findingText(FindingKind kind) { return wordsOf(kind).text; }

}  // namespace handlebody
