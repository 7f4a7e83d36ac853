"""A parameter sweep: one phantom, every combination of two options, a row for each as CSV.

The image is prepared anew for each contour; the volume is shared.
"""
import itertools

import handlebody

phantom = handlebody.phantom("rings", spacing=(2, 2, 2))
print("edge_length,curvature,iterations,vertices,genus,volume_mm3,dice")
for edge_length, curvature in itertools.product((2.5, 3.0, 4.0), (0.1, 0.3)):
    contour = handlebody.Contour(phantom.volume, seed=phantom.seed, edge_length=edge_length, curvature=curvature)
    contour.run()
    mesh = contour.mesh()
    certificate = mesh.certificate()
    dice = handlebody.compare(mesh, phantom.truth)["dice"]
    genus = "+".join(map(str, certificate["genus"]))
    print(f"{edge_length},{curvature},{contour.iteration},{certificate['vertices']},{genus},"
          f"{certificate['volume_mm3']:.0f},{dice:.4f}")
