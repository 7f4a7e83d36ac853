#!/usr/bin/python3
"""DICOM files made of a result, as readers that are not ours understand them.

    dicom_readers.py HANDLEBODY_CLI

A series of CT images of two boxes is written by pydicom; both are segmented, and the DICOM Segmentation and the Encapsulated
STL are read by pydicom, and by dcmdump, dcm2xml (DCMTK) and dciodvfy (dicom3tools) where they are installed. Exit code 77 (skipped)
without pydicom or numpy.
"""
import os
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import pydicom
    from pydicom.dataset import FileDataset, FileMetaDataset
    from pydicom.uid import ExplicitVRLittleEndian, generate_uid
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

SIZE, PITCH, THICK = (37, 35, 21), 1.5, 2.0  # voxels, and mm; 37 x 35 pixels fill no whole bytes
BOXES = {"left": ((5, 15), (6, 28), (4, 17)), "right": ((21, 32), (6, 28), (4, 17))}
CT_IMAGE, SEGMENTATION, STL = "1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.66.4", "1.2.840.10008.5.1.4.1.1.104.3"
TOLD = {"PatientName": "Doe^Jane", "PatientID": "4711", "PatientBirthDate": "19700203", "PatientSex": "F", "StudyDate": "20200131",
        "StudyTime": "101112", "AccessionNumber": "A1", "StudyID": "S1", "ReferringPhysicianName": "House^Greg"}


def write_series(folder):
    """The images, and the UIDs of study, frame of reference and images."""
    study, series, frame = generate_uid(), generate_uid(), generate_uid()
    voxels = np.random.default_rng(1).normal(40, 5, SIZE[::-1])
    for x, y, z in BOXES.values():
        voxels[slice(*z), slice(*y), slice(*x)] += 300
    images = []
    for k, pixels in enumerate(voxels.astype(np.int16)):
        meta = FileMetaDataset()
        meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID, meta.TransferSyntaxUID = CT_IMAGE, generate_uid(), ExplicitVRLittleEndian
        image = FileDataset(None, {}, file_meta=meta, preamble=bytes(128))
        image.is_little_endian, image.is_implicit_VR = True, False
        for key, value in TOLD.items():
            setattr(image, key, value)
        image.SOPClassUID, image.SOPInstanceUID, image.Modality = CT_IMAGE, meta.MediaStorageSOPInstanceUID, "CT"
        image.StudyInstanceUID, image.SeriesInstanceUID, image.FrameOfReferenceUID = study, series, frame
        image.SeriesNumber, image.InstanceNumber = 1, k + 1
        image.ImagePositionPatient, image.ImageOrientationPatient = [-20, 10, 5 + k * THICK], [1, 0, 0, 0, 1, 0]
        image.PixelSpacing, image.SliceThickness = [PITCH, PITCH], THICK
        image.Rows, image.Columns, image.SamplesPerPixel, image.PhotometricInterpretation = SIZE[1], SIZE[0], 1, "MONOCHROME2"
        image.BitsAllocated, image.BitsStored, image.HighBit, image.PixelRepresentation = 16, 16, 15, 1
        image.RescaleIntercept, image.RescaleSlope = 0, 1
        image.PixelData = pixels.tobytes()
        image.save_as(os.path.join(folder, f"{k:03d}.dcm"), write_like_original=False)
        images.append(image.SOPInstanceUID)
    return study, frame, images


def seed(box):
    at = [(low + high) / 2 for low, high in box]
    return f"{-20 + at[0] * PITCH},{10 + at[1] * PITCH},{5 + at[2] * THICK}"


def check(what, is_so):
    print(("ok      " if is_so else "WRONG   ") + what, flush=True)
    check.wrong += not is_so


check.wrong = 0


def check_source(name, made, source):
    study, frame, _ = source
    for key, value in TOLD.items():
        check(f"{name}: {key}", str(made.get(key)) == value)
    check(f"{name}: of the study", made.StudyInstanceUID == study)
    check(f"{name}: in the frame of reference", made.FrameOfReferenceUID == frame)


def check_segmentation(path, labels, source):
    made = pydicom.dcmread(path)
    check_source("segmentation", made, source)
    check("segmentation: class", made.SOPClassUID == SEGMENTATION and made.SegmentationType == "BINARY")
    check("segmentation: one bit", (made.BitsAllocated, made.BitsStored, made.HighBit) == (1, 1, 0))
    segments = {s.SegmentNumber: s for s in made.SegmentSequence}
    check("segmentation: names", [s.SegmentLabel for s in made.SegmentSequence] == list(BOXES))
    check("segmentation: terms", [s.SegmentedPropertyTypeCodeSequence[0].CodeValue for s in made.SegmentSequence] == ["64033007", "4147007"])
    check("segmentation: creator", str(made.ContentCreatorName) == "Miller^Ann")
    found = np.zeros_like(labels)
    for pixels, item in zip(made.pixel_array.reshape(-1, made.Rows, made.Columns), made.PerFrameFunctionalGroupsSequence):
        number = item.SegmentIdentificationSequence[0].ReferencedSegmentNumber
        z = float(item.PlanePositionSequence[0].ImagePositionPatient[2])
        found[round((z - 5) / THICK)][pixels > 0] = number
        of = item.DerivationImageSequence[0].SourceImageSequence[0].ReferencedSOPInstanceUID
        if of != source[2][round((z - 5) / THICK)]:
            check("segmentation: a frame refers to its image", False)
    check("segmentation: the voxels of the label map", len(segments) == 2 and (found == labels).all() and len(np.unique(found)) == 3)


def check_stl(path, stl, source):
    made = pydicom.dcmread(path)
    check_source("STL", made, source)
    check("STL: class and type", made.SOPClassUID == STL and made.MIMETypeOfEncapsulatedDocument == "model/stl")
    triangles = lambda data: np.frombuffer(data[84:84 + 50 * int.from_bytes(data[80:84], "little")], np.uint8).reshape(-1, 50)[:, 12:48]
    check("STL: the triangles of the mesh", np.array_equal(triangles(bytes(made.EncapsulatedDocument)), triangles(open(stl, "rb").read())))


def check_by_programs(path):
    """What they find wrong; dciodvfy takes warnings for no errors, and so do we."""
    for program in ("dcmdump", "dcm2xml", "dciodvfy"):
        if not shutil.which(program):
            print(f"        {program} is not installed")
            continue
        done = subprocess.run([program, path], capture_output=True, text=True, errors="replace")
        faults = [line for line in (done.stdout + done.stderr).splitlines() if line.startswith(("E:", "F:", "Error"))]
        print("\n".join(faults[:5]), end="\n" if faults else "")
        check(f"{os.path.basename(path)}: {program}", done.returncode == 0 and not faults)


def main():
    with tempfile.TemporaryDirectory() as folder:
        series = os.path.join(folder, "series")
        os.mkdir(series)
        source = write_series(series)
        words = [sys.argv[1], "segment", series, "--quiet", "--creator", "Miller^Ann"]
        for (name, box), term in zip(BOXES.items(), ("kidney", "mass")):
            words += ["--object-name", name, "--seed", seed(box), "--range", "190,inf", "--term", term]
        for ending in ("seg.dcm", "stl.dcm", "stl", "nrrd"):
            words += ["-o", f"{folder}/all.{ending}"]
        subprocess.run(words, check=True)
        head, body = open(folder + "/all.nrrd", "rb").read().split(b"\n\n", 1)
        if b"encoding: gzip" in head:
            import gzip
            body = gzip.decompress(body)
        check_segmentation(folder + "/all.seg.dcm", np.frombuffer(body, np.uint8).reshape(SIZE[::-1]), source)
        check_stl(folder + "/all.stl.dcm", folder + "/all.stl", source)
        for ending in ("seg.dcm", "stl.dcm"):
            check_by_programs(f"{folder}/all.{ending}")
    return check.wrong > 0


sys.exit(main())
