#pragma once
// The kinds of findings (finding.h), each with the values that it has; their names and English words are in
// finding_words.cpp and the sources beside it.

namespace handlebody {

enum class FindingKind {
  none,
  other,  //!< told in words that have no kind yet (the value "text")

  // About a surface that has come to an end.
  heldAtNeck,         //!< radius_mm, behind_ml, in_front_ml
  heldAtHole,         //!< the same
  heldWhereItWidens,  //!< the same
  noEdge,             //!< percent
  atVolumeBorder,     //!< percent
  atViewBorder,       //!< percent
  liesInWall,
  nothingAllowed,  //!< place
  heldAtPassages,  //!< radius_mm
  endsWithSearch,
  stuck,
  frozen,
  hardlyGrown,
  heldByCurvature,     //!< radius_mm
  closeChoice,         //!< objects, dice, next_ml, this_ml
  fewerCandidates,     //!< asked, taken
  leaked,              //!< iteration, disc; cause: passage
  leakWalled,          //!< the same
  leakStopped,         //!< the same; mesh_iteration
  passage,             //!< width_mm, place, before_mm, behind_mm
  passageTooNarrow,    //!< place, before_mm, behind_mm
  pinNotReached,       //!< pin, mesh_iteration
  vetoNotReached,      //!< iteration, mesh_iteration
  editNotReached,      //!< the same
  undecided,           //!< iteration, spot, allow, hold (of the command line); cause: one of the next
  wouldEnclose,        //!< ml, place
  wouldComeOff,        //!< ml, place
  frontsWouldMeet,     //!< place
  wouldMakeTunnel,     //!< place, around_mm
  wouldChange,         //!< event, place
  runsWithoutSurface,  //!< runs, of
  otherTopology,       //!< runs, of
  volumeVaries,        //!< percent
  volumeBesideRuns,    //!< volume_ml, least_ml, most_ml
  polishLeaves,        //!< thin_faces, sharp_edges, place; text (polish.h)
  givenWithThin,       //!< thin_faces, sharp_edges
  givenShares,         //!< voxels
  madeWithEarlier,     //!< object
  seedNotEnclosed,     //!< place, distance_mm
  clickEnclosed,       //!< the same
  ballEntered,         //!< place, radius_mm, distance_mm

  // Why a place was rolled back, a change was held, or what did not fit before the one that was made.
  keptApart,
  overLimit,
  changesAgain,
  nothingKept,
  frontsNotJoined,  //!< fronts; cause
  frontsWait,       //!< fronts, left
  ringAdded,        //!< cause
  ringsAdded,       //!< rings; cause
  maybeShorter,
  meetsPinned,
  tooMuchWork,
  workIsDone,
  meetInside,
  noHandle,
  noPatch,
  enclosesForbidden,
  openingTooLarge,
  pinnedThere,
  nothingLeft,
  entersWall,
  unseenChange,
  eventsDisagree,
  otherEuler,
  otherComponents,
  cavityOutside,
  bodyInBody,
  stillIntersects,
  enclosesNothing,
  closesOverPinned,
  pinnedWouldChange,
  editOfPinned,
  editIntoWall,
  tooManyComponents,
  tooManyTunnels,
  edgeWithOneFace,
  facesDisagree,
  facesOpposed,
  facesTwice,
  removedVertex,
  vertexTwice,
  vertexWithoutFace,
  wrongHalfedge,
  edgesTwice,
  severalFans,
  wrongCounts,

  // Why an edit by hand was refused.
  noVertexInBall,
  planeMisses,
  planeMissesNear,
  noFlatCap,
  cutPartsNothing,
  pullTooFar,
  nothingWouldBeLeft,
  meetsItself,

  // What was asked for has no meaning, or not there.
  noSeed,
  seedRadius,
  seedOutside,       //!< place, voxel
  clickOutside,      //!< place
  clicksContradict,  //!< place, outside
  ballOverSeed,      //!< place, outside, radius_mm
  clickOverStart,    //!< outside
  seedNotInRange,    //!< place, intensity, low, high
  noDarkObject,
  noBrightObject,
  noObject,
  fillsView,
  rangeEmpty,
  rangeWithoutVoxels,  //!< low, high, least, most
  rangeAndBackground,
  edgeTooShort,      //!< edge_mm
  seedInObject,      //!< place, object
  wallOverSeed,      //!< place
  wallLeavesNoRoom,  //!< place
  wallWithin,        //!< place
  wallAcross,        //!< place
  wallOver,          //!< place
  objectOver,        //!< object
  clicksVersusPins,
  vetoTooLate,           //!< iteration, now
  vetoFindsNothing,      //!< iteration
  pinTooLate,            //!< pin, now
  pinHoldsNothing,       //!< pin, now
  editTooLate,           //!< iteration, now
  editRefused,           //!< iteration; cause
  editFindsNoTunnel,     //!< iteration, place
  editFindsNoComponent,  //!< iteration, place
  editFindsNoCavity,     //!< iteration, place
  editWithoutCap,        //!< iteration, place
  editRemovesNothing,    //!< iteration
  editLeavesNothing,     //!< iteration
  surfaceVanished,       //!< iterations

  // What went wrong in a frame over time.
  frameUnreadable,  //!< cause
  frameNotRead,     //!< the same, where its file must not be named
  frameNoObject,    //!< cause
  frameVanished,
  frameLeaked,           //!< cause: passage
  frameJumped,           //!< from_ml, from_frame, to_ml
  frameGenusChanged,     //!< genus_before, genus; one component before and after
  frameCameApart,        //!< components, genus_before, genus; one component before
  frameCameTogether,     //!< components_before, genus_before, genus; one component after
  frameTopologyChanged,  //!< components_before, components, genus_before, genus
  frameHeldAtPlace,      //!< place
  frameHeldAtPlaces,     //!< places, place: the first
  frameOtherObject,      //!< candidate; cause
  frameMovedObject,      //!< percent: shared, as Dice; from_frame
  frameMovedInstead,     //!< from_frame; cause
  frameFromFailed,       //!< from_frame
  frameAtLimit,
  frameStuck,
  frameFrozen,

  // What is wrong with a file: whole sentences that name it …
  fileRefused,        //!< file; cause
  fileRefusedWith,    //!< file; cause: a sentence
  fileRefusedInLine,  //!< file, line; cause
  fileNotWritten,     //!< file; cause
  noSuchSeries,       //!< file, series
  notAStart,          //!< file; cause
  startChanged,       //!< file
  volumeChanged,      //!< file
  seriesChanged,      //!< file, series
  seriesNotFound,     //!< file
  wallsChanged,       //!< file
  wallsOtherSize,     //!< file, size, volume
  wallsOtherPlace,    //!< file
  wallsEmpty,         //!< file
  wallsOverTime,      //!< file, frames
  labelsEmpty,        //!< file
  tooManyLabels,      //!< file, most
  otherVolume,        //!< file, object
  sessionIsFolder,    //!< file
  sessionNotOpened,   //!< file; cause
  sessionNotRead,     //!< file
  notJson,            //!< file
  notASession,        //!< file; cause: a sentence
  sessionWithoutVolume,
  sessionWithoutWalls,
  sessionWithoutStart,
  sessionWithoutObjects,
  sessionWithoutSeeds,

  // … what is wrong with it: any file …
  noSuchFile,
  noSuchFileOrFolder,
  notAFile,
  neitherFileNorFolder,
  notOpened,
  cannotBeOpened,
  cannotBeRead,
  notReadToEnd,
  emptyFile,
  folderUnreadable,
  folderUnreadableFor,  //!< reason
  notEnoughMemory,
  noMemoryToUnpack,
  truncatedOrDamaged,
  truncatedOrDamagedFor,  //!< reason
  headerUnreadable,       //!< format, reason
  headerCutOff,           //!< format
  headerTruncated,        //!< format
  headerTruncatedAt,      //!< format, field
  headerDamaged,          //!< format, field
  damagedAt,              //!< format, field
  truncatedFormat,        //!< format
  notOfFormat,            //!< format

  // … a volume …
  unknownVolume,
  gitPointer,
  packedDicom,
  trackedFrames,
  flatImage,
  thinImage,
  flatColour,  //!< values
  noVoxels,
  noVoxelsInHeader,
  badSpacing,
  badPlace,
  sheared,
  noTimePoints,
  tooManyTimePoints,  //!< frames
  tooLarge,           //!< declared_gb, memory_gb
  implausibleSize,    //!< size
  dataFileMissing,    //!< data
  dataCutOff,         //!< declared, held: bytes
  packedDataCutOff,   //!< the same
  voxelsTruncated,
  voxelDataTruncated,
  checksumDiffers,
  infiniteVoxel,   //!< index
  infiniteVoxels,  //!< voxels, index: of the first
  noNumbers,
  vectorVoxels,  //!< components
  fourDimensions,
  tooManyDimensions,  //!< dimensions
  voxelType,          //!< type
  voxelTypeUnknown,
  niftiVoxelType,  //!< type
  notNifti,
  analyzeFile,
  sformWithoutLength,
  sformNoNumber,
  listNotSupported,      //!< pattern
  encodingNotSupported,  //!< encoding
  dataFilesUneven,
  skipNotSupported,
  voxelsNoNumbers,  //!< word
  manyDataFiles,
  voxelsAsText,
  folderTimePoints,  //!< frames
  folderOtherGrid,   //!< first
  folderOtherType,   //!< first
  slicePages,        //!< pages
  sliceDiffers,      //!< first
  notWholeNumbers,
  noLabelCalled,      //!< name, names
  noLabelNamed,       //!< name
  labelsCalledAlike,  //!< name

  // … a DICOM series: slice and part are names of files …
  dicomDamaged,
  partDamaged,           //!< part
  partCutOff,            //!< part
  partWithoutImage,      //!< part
  partHeaderUnreadable,  //!< part, reason
  notDicomImage,
  noDicomImages,
  imagesInSubfolders,
  sliceUnplaced,       //!< slice
  slicePixelSpacing,   //!< slice
  sliceDirections,     //!< slice
  sliceWithoutPixels,  //!< slice
  sliceNotOpened,      //!< slice
  sliceNotReadToEnd,   //!< slice
  sliceOtherSize,      //!< slice
  sliceDamaged,        //!< slice, reason
  sliceNotDecoded,     //!< slice
  sliceHoldsLess,      //!< slice
  sliceFewerFrames,    //!< slice
  slicePalette,        //!< slice
  slicePackedLess,     //!< slice, declared, held: bytes
  sliceValueTooLarge,  //!< slice
  slicesOtherSize,
  slicesOtherOrientation,
  slicesOtherSpacing,
  slicesPartlyColour,
  slicesNarrow,
  slicesIncomplete,
  slicesInOnePlace,
  singleSlice,
  slicesShifted,      //!< shift_mm
  slicesUneven,       //!< causes: gaps
  sliceMissing,       //!< the same
  slicesMissing,      //!< the same; missing
  gapOf,              //!< gap_mm
  gapsOf,             //!< gaps, gap_mm
  nextGapsOf,         //!< the same
  nextGapsOfMore,     //!< the same
  tooUneven,          //!< cause: one of the three before
  cine,               //!< frames
  framesImplausible,  //!< slice
  pixelBits,          //!< stored, allocated, slice
  pixelSamples,       //!< samples, slice
  colourBits,         //!< bits, slice
  packedBit,          //!< slice
  colourSpace,        //!< space, slice
  segmentUnknown,
  segmentationNotBinary,  //!< bits
  segmentationPacked,
  severalToChoose,
  holdsLess,
  framesUnplaced,
  framesNotBehind,
  sliceDistanceUnknown,
  frameDistance,
  framesUneven,

  // … and the process that decodes it …
  decoderMissing,     //!< program
  decoderNotStarted,  //!< reason
  decoderNotRun,      //!< program, reason
  decoderBroke,       //!< how
  decoderBrokeOn,     //!< part, how
  decoderStuck,
  decoderStuckOn,  //!< part
  decoderAnswer,
  decoderAnswerOnIt,
  decoderAnswerOn,  //!< part
  decoderGaveLess,
  decodingMemory,
  decodingFailed,  //!< reason

  // … a mesh …
  meshDamaged,
  notStl,
  notAMesh,
  triangleStrips,
  noTriangles,
  badCoordinate,
  faceVertexMissing,
  faceTooFewCorners,
  faceDamaged,
  vertexDamaged,
  trianglesWithoutArea,
  encryptedFile,
  extensionNotSupported,  //!< format, extension

  // … a surface to begin with: "it …" …
  hasNoTriangles,
  isNotClosed,
  isNotManifold,
  isNotOriented,
  intersectsItself,  //!< pairs
  intersectsRounded,
  isMisplaced,
  enclosesNoVolume,
  hasNoLabel,  //!< label
  hasNoVoxel,
  hasNoneAlone,  //!< label
  keepsTunnels,  //!< tunnels, most
  meshWithoutLabels,
  lostLabel,  //!< label
  labelsTooFine,
  surfaceTooLarge,  //!< most

  // … and why it was not written.
  nameIsFolder,
  folderHasName,
  notOnDisk,
  diskMayBeFull,
  fileNotOpened,
  niftiTooLarge,
  dicomMeshTooLarge,
  dicomTooLarge,
  packageTooLarge,
  objectWithoutVoxel,  //!< object
  permissionDenied,
  noSpaceLeft,
  readOnlyDisk,
  noFileOrDirectory,
  nameTooLong,
  notADirectory,
  quotaExceeded,
  inputOutputError,

  // What is asked for lies outside of the volume, or has nothing to act on.
  pinOutside,        //!< place
  wallOutside,       //!< place
  wallDiscOutside,   //!< place
  allowedOutside,    //!< place
  heldOutside,       //!< place
  startOutside,      //!< file
  startMeetsObject,  //!< file, object
  startCannotChange,
  objectNoWall,  //!< object
  wallMapOtherSize,
  nothingToAllow,
  nothingToHold,
  nothingToAsk,
  pinBeforeStep,
  sensitivityNames,
  sensitivityGiven,
  sensitivityVanished,

  // Why a format cannot be written for what is open.
  noDicomMade,  //!< cause
  notFromDicom,
  seriesUnplaced,
  positionsOfUltrasound,
  spacingGiven,
  dicomTextTooLong,  //!< text
  dicomTextControl,  //!< text
  labelsNotOnGrid,
  noMesher,
  noTetrahedra,  //!< object; cause
  frameMissing,  //!< file, frame, last
  onlyFrame,     //!< file, frame

  // What is to be known of a volume that was opened: its header …
  colourAsLuminance,
  unitAsMillimetres,   //!< unit
  unitsAsMillimetres,  //!< units
  lengthsInMetres,
  lengthsInMicrometres,
  placeUnknown,
  axesTakenAsLps,
  originAssumed,
  formsDisagree,  //!< apart_mm
  tiffWithoutPlace,
  isSegmentation,
  sliceDistanceGuessed,  //!< spacing_mm, thickness_mm
  spacingOverridden,     //!< x_mm, y_mm, z_mm
  frameZeroUsed,         //!< frames
  firstLayerUsed,        //!< layers
  firstFrameUsed,        //!< frames
  uncalibrated,
  volumeOffVoxels,   //!< mesh_ml, voxels_ml, percent: more than these
  edgesNotAsAsked,   //!< median_mm, asked_mm
  voxelsNotNumbers,  //!< none, voxels

  // … its slices, and the folder that they are in …
  sliceIsCopy,
  slicesAreCopies,         //!< copies
  slicesTilted,            //!< degrees
  slicesResampled,         //!< spacing_mm; causes: gaps
  sliceMissingResampled,   //!< the same
  slicesMissingResampled,  //!< the same; missing
  placesAssumed,
  patientPlaceAssumed,
  placeInUltrasound,
  lowIsBright,
  slopeIsZero,
  breaksOffAfterOne,  //!< frames
  breaksOff,          //!< frames, whole
  fileWithoutImage,
  filesWithoutImage,  //!< files
  otherFileDamaged,
  otherFilesDamaged,     //!< files
  fileNotDicom,          //!< names
  filesNotDicom,         //!< files, names
  filesNotDicomAndMore,  //!< files, names, more
  fileNotDicomUnnamed,
  filesNotDicomUnnamed,  //!< files
  stacksAlone,           //!< causes: stacks
  stacksAloneUnnamed,
  stackOf,  //!< series, stack, slices

  // … and the series to choose from.
  nothingChosen,        //!< cause
  seriesToChoose,       //!< series: how many; causes: those
  seriesOfFile,         //!< series, what, size, spacing_mm
  seriesOfFiles,        //!< the same; files
  brokenSeriesOfFile,   //!< series, what
  brokenSeriesOfFiles,  //!< the same; files
  noVolume,             //!< cause

  // What is to be known of figures.
  ofFile,           //!< file; cause: a sentence
  ofObject,         //!< object; cause: a sentence
  objectEmpty,      //!< object
  objectOpen,       //!< object
  objectNotAlike,   //!< object
  objectMisplaced,  //!< object
  objectBranches,   //!< object
  objectInsideOut,  //!< object
  objectsApart,     //!< apart_mm, centres_mm
  objectsTurned,    //!< the same
  noLatticePoint,
  surfacePartlyOutside,
  voxelsWithoutValue,  //!< voxels
  noVoxelInside,
  noCavity,           //!< object
  leftOutUnseeded,    //!< object
  otherVersion,       //!< session, version, here
  oneFrameOfSeveral,  //!< frame

  // What is wrong with an option, a session or a label map …
  startAndGiven,
  noEffectOnGiven,
  noEffectOnMesh,  //!< file
  noEffectWithRange,
  wallOverGiven,    //!< place
  givenComponents,  //!< file, count, most
  givenTunnels,     //!< the same
  noSurface,        //!< file; cause: as of notAStart

  // … and with a part or a place of a file: damagedBecause has one of the next.
  damagedBecause,     //!< format; cause
  partMissing,        //!< part
  objectMissing,      //!< object: its number
  objectHoldsItself,  //!< the same
  objectTwice,        //!< the same
  objectWithoutNumber,
  objectsNested,
  objectsTooMany,  //!< most
  itemWithoutObject,
  badTransform,
  unitUnknown,  //!< unit
  packingOf,    //!< part
  sizeOf,       //!< part
  xmlAt,        //!< line, part; cause: one of the next
  xmlFault,     //!< reason
  xmlNested,
  xmlWithType,
  xmlTagTooLong,
  badNumber,
  badList,

  // Why what is asked for has no meaning …
  balloonNotPositive,
  curvatureNegative,
  iterationsNegative,
  threadsOutside,
  smoothingNegative,
  edgeNotPositive,
  smoothingTooLarge,  //!< given_mm, longest_mm, most_mm
  edgeTooLarge,       //!< the same
  componentsTooFew,
  genusNegative,
  wallWithoutRadius,      //!< place
  wallDiscWithoutRadius,  //!< place
  wallDiscWithoutNormal,  //!< place
  wallMapNotRead,
  startNotRead,  //!< file
  vetoWithoutPlace,
  vetoOfEdit,            //!< iteration
  pinWithoutRadius,      //!< place
  pinIterationNegative,  //!< place
  editWithoutPlace,
  editNotFinite,       //!< iteration
  editWithoutRadius,   //!< iteration
  editRadiusNegative,  //!< iteration
  editWithoutNormal,   //!< iteration
  editTwice,           //!< iteration

  // … had nothing to act on when the growth ended, or cannot be worked out.
  vetoLeftOver,  //!< iteration, now
  pinLeftOver,   //!< pin, now
  editLeftOver,  //!< iteration, now
  surfaceTooFar,
  tooManySamples,  //!< sampling_mm, most

  // What is wrong with a session: field is the place in it, "requested.seeds[0].centre" …
  fieldMissing,       //!< field
  fieldUnknown,       //!< field
  fieldNotObject,     //!< field
  fieldNotList,       //!< field
  fieldEntries,       //!< field, needed, count
  fieldNotText,       //!< field
  fieldNotFlag,       //!< field, value
  fieldNotNumber,     //!< field, value
  fieldNotWhole,      //!< field, value
  fieldBelow,         //!< field, value, least
  fieldNotAbove,      //!< field, value, least
  fieldOutside,       //!< field, value, least, most
  fieldUnknownWord,   //!< field, value
  fieldEmpty,         //!< field
  fieldNoRange,       //!< field
  fieldNotAscending,  //!< field
  fieldNoLabel,       //!< field
  fieldNoDirection,   //!< field
  fieldNoName,        //!< field, most, separators
  fieldBadCode,       //!< field
  fieldNotWritable,   //!< field
  jsonNumberTooLarge,
  overTimeOfSeveral,
  correctedFrameWithStart,

  // … or with what is given beside it …
  severalObjects,  //!< file, objects
  wallsNotNeeded,  //!< file
  startNotNeeded,  //!< file
  onlyOneFile,     //!< file, other

  // … with what is asked of a volume …
  seriesNotDicom,      //!< file, format
  spacingNotPositive,  //!< file

  // … and why it is not written.
  noMeshEnding,      //!< file
  noValuesEnding,    //!< file
  noVolumeEnding,    //!< file
  noSequenceEnding,  //!< file
  volumeTooThin,
  noScene,
  noTemporaryFolder,  //!< cause
};
inline constexpr int kFindingKinds = static_cast<int>(FindingKind::noTemporaryFolder) + 1;

}  // namespace handlebody
