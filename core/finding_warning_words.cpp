// The words of findings about files that can be read and figures that can be told: the part of the table of
// finding_words.cpp that says what is to be known of them.

#include "core/finding_words.h"

// As in finding_words.cpp.
#define QT_TRANSLATE_NOOP(context, text) text

namespace handlebody {

namespace {

using K = FindingKind;

constexpr FindingWords kWords[] = {
    {K::colourAsLuminance, "colour-as-luminance",
     QT_TRANSLATE_NOOP("Findings", "Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).")},
    {K::unitAsMillimetres, "unit-as-millimetres",
     QT_TRANSLATE_NOOP("Findings", "The distance unit {unit} is taken as millimetres.")},
    {K::unitsAsMillimetres, "units-as-millimetres",
     QT_TRANSLATE_NOOP("Findings", "The space units {units} are taken as millimetres.")},
    {K::lengthsInMetres, "lengths-in-metres",
     QT_TRANSLATE_NOOP("Findings",
                       "The lengths in the header are in metres and were turned into millimetres.")},
    {K::lengthsInMicrometres, "lengths-in-micrometres",
     QT_TRANSLATE_NOOP("Findings",
                       "The lengths in the header are in micrometres and were turned into millimetres.")},
    {K::placeUnknown, "place-unknown",
     QT_TRANSLATE_NOOP(
         "Findings", "The header does not say how the volume lies in space (qform and sform codes are 0).")},
    {K::axesTakenAsLps, "axes-taken-as-lps",
     QT_TRANSLATE_NOOP("Findings",
                       "The header does not say how the volume lies in space; its axes are taken as LPS.")},
    {K::originAssumed, "origin-assumed",
     QT_TRANSLATE_NOOP("Findings",
                       "The header does not say where the first voxel lies; it is taken to lie at 0, 0, 0.")},
    {K::formsDisagree, "forms-disagree",
     QT_TRANSLATE_NOOP("Findings",
                       "The sform and the qform of the header disagree (by up to {apart_mm:0f} mm); the "
                       "qform is used.")},
    {K::tiffWithoutPlace, "tiff-without-place",
     QT_TRANSLATE_NOOP("Findings",
                       "TIFF does not say how far apart the slices are nor how they lie; 1 mm and LPS axes "
                       "are assumed.")},
    {K::isSegmentation, "is-segmentation",
     QT_TRANSLATE_NOOP("Findings", "This is a segmentation: its voxels hold the numbers of the segments.")},
    {K::sliceDistanceGuessed, "slice-distance-guessed",
     QT_TRANSLATE_NOOP(
         "Findings",
         "The header does not state the distance of the slices: {spacing_mm:4g} mm are taken, the "
         "least between its frames, though a slice is {thickness_mm:4g} mm thick. Slices may be "
         "left out.")},
    {K::spacingOverridden, "spacing-overridden",
     QT_TRANSLATE_NOOP("Findings",
                       "The spacing was given by the user; the file says {x_mm:4g} mm, {y_mm:4g} mm, "
                       "{z_mm:4g} mm.")},
    {K::frameZeroUsed, "frame-zero-used",
     "There are {frames:0f} time points; frame 0 is used ({option:frame} chooses another)."},
    {K::firstLayerUsed, "first-layer-used",
     QT_TRANSLATE_NOOP(
         "Findings",
         "The segmentation has {layers:0f} layers, since segments overlap: only the segments of "
         "the first layer are read.")},
    {K::firstFrameUsed, "first-frame-used",
     QT_TRANSLATE_NOOP("Findings", "There are {frames:0f} time points; the first one is used.")},
    {K::uncalibrated, "uncalibrated",
     "The volume is uncalibrated: its file does not give the spacing, 1 mm is assumed where it is missing, "
     "and lengths and volumes mean nothing until {option:spacing} gives it."},
    {K::volumeOffVoxels, "volume-off-voxels",
     QT_TRANSLATE_NOOP("Findings",
                       "The mesh encloses {mesh_ml:4g} ml, the voxels that it was made of {voxels_ml:4g} ml "
                       "({percent:0f} %): they are too few, or too narrow, for their shape to be kept.")},
    {K::edgesNotAsAsked, "edges-not-as-asked",
     QT_TRANSLATE_NOOP(
         "Findings",
         "The edges of the mesh are {median_mm:3g} mm long in the median, not {asked_mm:4g} "
         "mm as was asked for: with such edges it would leave the voxels or intersect itself.")},
    {K::voxelsNotNumbers, "voxels-not-numbers",
     QT_TRANSLATE_NOOP("Findings",
                       "{none:0f} of {voxels:0f} voxels are not a number: they count as outside of the "
                       "field of view.")},

    {K::sliceIsCopy, "slice-is-copy",
     QT_TRANSLATE_NOOP("Findings", "1 slice is a copy of another and was left out.")},
    {K::slicesAreCopies, "slices-are-copies",
     QT_TRANSLATE_NOOP("Findings", "{copies:0f} slices are copies of others and were left out.")},
    {K::slicesTilted, "slices-tilted",
     QT_TRANSLATE_NOOP("Findings",
                       "The slices are tilted by {degrees:1f} degrees (gantry tilt) and were resampled to a "
                       "straight grid.")},
    {K::slicesResampled, "slices-resampled",
     QT_TRANSLATE_NOOP("Findings",
                       "The slices are unevenly spaced ({list}); they were resampled to a distance of "
                       "{spacing_mm:4g} mm. What lies in the gaps is interpolated.")},
    {K::sliceMissingResampled, "slice-missing-resampled",
     QT_TRANSLATE_NOOP("Findings",
                       "The slices are unevenly spaced ({list}), 1 seems to be missing; they were resampled "
                       "to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.")},
    {K::slicesMissingResampled, "slices-missing-resampled",
     QT_TRANSLATE_NOOP("Findings",
                       "The slices are unevenly spaced ({list}), {missing:0f} seem to be missing; they were "
                       "resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is "
                       "interpolated.")},
    {K::placesAssumed, "places-assumed",
     QT_TRANSLATE_NOOP("Findings",
                       "The header does not say where the slices lie; they are taken one behind the other, "
                       "with LPS axes.")},
    {K::patientPlaceAssumed, "patient-place-assumed",
     QT_TRANSLATE_NOOP("Findings",
                       "The file does not say how the volume lies in the patient: columns are taken to run "
                       "to the right, rows to the back and slices downwards.")},
    {K::placeInUltrasound, "place-in-ultrasound",
     QT_TRANSLATE_NOOP(
         "Findings",
         "Positions are in the frame of the ultrasound volume, not of the patient: its axes are "
         "taken as LPS.")},
    {K::lowIsBright, "low-is-bright",
     QT_TRANSLATE_NOOP("Findings", "MONOCHROME1: low values are bright on a display.")},
    {K::slopeIsZero, "slope-is-zero",
     QT_TRANSLATE_NOOP(
         "Findings", "The header scales voxels by 0, which would make them all alike; 1 is taken instead.")},
    {K::breaksOffAfterOne, "breaks-off-after-one",
     QT_TRANSLATE_NOOP("Findings",
                       "The file breaks off: its header declares {frames:0f} time points, and only the first "
                       "one is there in full.")},
    {K::breaksOff, "breaks-off",
     QT_TRANSLATE_NOOP("Findings",
                       "The file breaks off: its header declares {frames:0f} time points, and only the first "
                       "{whole:0f} are there in full.")},
    {K::fileWithoutImage, "file-without-image",
     QT_TRANSLATE_NOOP("Findings", "1 file of DICOM in the folder is without an image and left out.")},
    {K::filesWithoutImage, "files-without-image",
     QT_TRANSLATE_NOOP("Findings",
                       "{files:0f} files of DICOM in the folder are without an image and left out.")},
    {K::otherFileDamaged, "other-file-damaged",
     QT_TRANSLATE_NOOP("Findings", "1 file of other series is truncated or damaged.")},
    {K::otherFilesDamaged, "other-files-damaged",
     QT_TRANSLATE_NOOP("Findings", "{files:0f} files of other series are truncated or damaged.")},
    {K::fileNotDicom, "file-not-dicom",
     QT_TRANSLATE_NOOP("Findings", "1 file in the folder is not DICOM and left out: {names}.")},
    {K::filesNotDicom, "files-not-dicom",
     QT_TRANSLATE_NOOP("Findings", "{files:0f} files in the folder are not DICOM and left out: {names}.")},
    {K::filesNotDicomAndMore, "files-not-dicom-and-more",
     QT_TRANSLATE_NOOP("Findings",
                       "{files:0f} files in the folder are not DICOM and left out: {names} and {more:0f} "
                       "more.")},
    {K::fileNotDicomUnnamed, "file-not-dicom-unnamed",
     QT_TRANSLATE_NOOP("Findings", "1 file in the folder is not DICOM and left out.")},
    {K::filesNotDicomUnnamed, "files-not-dicom-unnamed",
     QT_TRANSLATE_NOOP("Findings", "{files:0f} files in the folder are not DICOM and left out.")},
    {K::stacksAlone, "stacks-alone",
     QT_TRANSLATE_NOOP("Findings", "Its stacks of one pitch each are to be had alone: {list}.")},
    {K::stacksAloneUnnamed, "stacks-alone-unnamed",
     QT_TRANSLATE_NOOP("Findings", "Its stacks of one pitch each are to be had alone.")},
    {K::stackOf, "stack-of", "{series}#{stack:0f} ({slices:0f} slices)"},

    {K::nothingChosen, "nothing-chosen", QT_TRANSLATE_NOOP("Findings", "Nothing is chosen: {cause}.")},
    {K::seriesToChoose, "series-to-choose",
     "it holds {series:0f} series or stacks, choose one with {option:series}: {choices}"},
    {K::seriesOfFile, "series-of-file",
     QT_TRANSLATE_NOOP("Findings", "{series} ({what}1 file, {size} voxels of {spacing_mm: 4g} mm)")},
    {K::seriesOfFiles, "series-of-files",
     QT_TRANSLATE_NOOP("Findings",
                       "{series} ({what}{files:0f} files, {size} voxels of {spacing_mm: 4g} mm)")},
    {K::brokenSeriesOfFile, "broken-series-of-file",
     QT_TRANSLATE_NOOP("Findings", "{series} ({what}1 file, no volume)")},
    {K::brokenSeriesOfFiles, "broken-series-of-files",
     QT_TRANSLATE_NOOP("Findings", "{series} ({what}{files:0f} files, no volume)")},
    {K::noVolume, "no-volume", QT_TRANSLATE_NOOP("Findings", "{cause}.")},

    {K::ofFile, "of-file", QT_TRANSLATE_NOOP("Findings", "{file}: {cause}")},
    {K::ofObject, "of-object", QT_TRANSLATE_NOOP("Findings", "{object}: {cause}")},
    {K::objectEmpty, "object-empty",
     QT_TRANSLATE_NOOP("Findings", "{object} is empty: there are no distances.")},
    {K::objectOpen, "object-open",
     QT_TRANSLATE_NOOP("Findings",
                       "{object} is not closed: it has no volume, and there is no Dice coefficient. "
                       "Distances are measured from and to what there is of its surface.")},
    {K::objectNotAlike, "object-not-alike",
     QT_TRANSLATE_NOOP("Findings",
                       "{object} is closed, but not all of its faces are oriented alike: it has no volume, "
                       "and there is no Dice coefficient.")},
    {K::objectMisplaced, "object-misplaced",
     QT_TRANSLATE_NOOP(
         "Findings",
         "{object} has parts that lie where they bound nothing, as one does that is inside out: "
         "it has no volume, and there is no Dice coefficient.")},
    {K::objectBranches, "object-branches",
     QT_TRANSLATE_NOOP("Findings", "{object} is not a manifold: its genus and cavities cannot be counted.")},
    {K::objectInsideOut, "object-inside-out",
     QT_TRANSLATE_NOOP("Findings", "{object} is inside out; it was turned.")},
    {K::objectsApart, "objects-apart",
     QT_TRANSLATE_NOOP("Findings",
                       "A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of "
                       "their boxes {centres_mm:4g} mm.")},
    {K::objectsTurned, "objects-turned",
     QT_TRANSLATE_NOOP("Findings",
                       "A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of "
                       "their boxes {centres_mm:4g} mm. With the signs of x and y turned in one of them they "
                       "would meet: is one in RAS and does not say so?")},
    {K::noLatticePoint, "no-lattice-point",
     "No point of the lattice lies in A or B: there is no Dice coefficient; {option:sampling} makes the "
     "lattice of "
     "two meshes finer."},
    {K::surfacePartlyOutside, "surface-partly-outside",
     QT_TRANSLATE_NOOP(
         "Findings",
         "A part of the surface lies outside of the volume: intensities and label maps are of the rest.")},
    {K::voxelsWithoutValue, "voxels-without-value",
     QT_TRANSLATE_NOOP("Findings", "{voxels:0f} voxels inside have no finite value and do not count.")},
    {K::noVoxelInside, "no-voxel-inside",
     QT_TRANSLATE_NOOP("Findings", "No voxel with a value has its centre inside.")},
    {K::noCavity, "no-cavity",
     QT_TRANSLATE_NOOP("Findings", "“{object}” has no cavity, and so no wall around one.")},

    // Of a session that is grown again.
    {K::leftOutUnseeded, "left-out-unseeded",
     QT_TRANSLATE_NOOP("Findings", "object '{object}' has no seed and is left out.")},
    {K::otherVersion, "other-version",
     QT_TRANSLATE_NOOP("Findings",
                       "{session} was made by version {version}; this is {here}, and the mesh may differ.")},
    {K::oneFrameOfSeveral, "one-frame-of-several",
     QT_TRANSLATE_NOOP("Findings",
                       "the session carries the surface through other frames, too, and these figures are of "
                       "frame {frame:0f} "
                       "alone; handlebody-cli replay writes those of all.")},

    // Of options that change nothing, or that what was given cannot keep.
    {K::fewerCandidates, "fewer-candidates",
     "the clicks may mean fewer objects than {asked:0f}, which is the one that {option:candidate} asks for: "
     "number {taken:0f}, the last of them, was taken"},
    {K::noEffectOnGiven, "no-effect-on-given",
     "has no effect on an object that {option:given} says: its surface stays as it is, and nothing grows."},
    {K::noEffectOnMesh, "no-effect-on-mesh",
     QT_TRANSLATE_NOOP("Findings",
                       "has no effect: it says how a label becomes a surface, and {file} is a mesh.")},
    {K::noEffectWithRange, "no-effect-with-range",
     "has no effect with {option:range}, by which the intensities alone say what the object is: leave one of "
     "them out."},
    {K::wallOverGiven, "wall-over-given",
     "The wall at {place} mm lies over the surface that {option:given} says, or within it, and that surface "
     "stays as it is."},
    {K::givenComponents, "given-components",
     QT_TRANSLATE_NOOP("Findings",
                       "{file} has {count:0f} components, and is to have no more than {most:0f}.")},
    {K::givenTunnels, "given-tunnels",
     QT_TRANSLATE_NOOP("Findings",
                       "{file} has {count:0f} handles or tunnels, and is to have no more than {most:0f}.")},
};

}  // namespace

std::span<const FindingWords> wordsOfWarnings() { return kWords; }

}  // namespace handlebody
