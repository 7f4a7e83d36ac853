"""A leak study: how far may the range of intensities be widened before the surface leaks?

Two chambers with a wall and a hole of two voxels between them, seeded in one. For each upper end of the range: alarms,
volume, and the volume with a disc where the alarm came.
"""
import handlebody

wall = handlebody.phantom("wall", gap=2)


def grown(**options):
    contour = handlebody.Contour(wall.volume, seed=wall.seed, **options)
    contour.run()
    return contour


def millilitres(contour):
    return contour.certificate()["volume_mm3"] / 1000


print("upper,leaks,volume_ml,volume_with_disc_ml")
for upper in (75, 90, 105, 120):
    contour = grown(range=(0, upper))
    discs = [leak["wall_disc"] for leak in contour.leaks]
    mended = grown(range=(0, upper), wall_disc=discs) if discs else contour
    print(f"{upper},{len(discs)},{millilitres(contour):.2f},{millilitres(mended):.2f}")
