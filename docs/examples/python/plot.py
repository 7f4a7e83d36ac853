"""A contour that is watched while it grows: its volume over the iterations, its changes of topology, and the surface.

Needs matplotlib (python3-matplotlib); writes torus.png.
"""
import matplotlib.pyplot as plt

import handlebody

phantom = handlebody.phantom("torus", spacing=(1.5, 1.5, 1.5))
contour = handlebody.Contour(phantom.volume, seed=phantom.seed)
volumes = []
while contour.stop_reason == "running":
    volumes.append(contour.step()["volume_mm3"] / 1000)

figure = plt.figure(figsize=(11, 4))
curve = figure.add_subplot(1, 3, 1)
curve.plot(range(1, len(volumes) + 1), volumes)
for event in contour.events:
    if event["before"] != event["after"]:
        curve.axvline(event["iteration"], color="tab:red", linewidth=0.5)
curve.set(xlabel="iteration", ylabel="volume (ml)", title="growth; red: changes of topology")

# Arrays are indexed [z, y, x], points are x, y, z.
grid = phantom.volume.grid
middle = grid.shape[0] // 2
image = figure.add_subplot(1, 3, 2)
image.imshow(phantom.volume.array[middle], cmap="gray")
image.contour(contour.label_map()[middle], [0.5], colors="tab:orange")
image.set_title(f"slice {middle}")

surface = figure.add_subplot(1, 3, 3, projection="3d")
x, y, z = contour.vertices.T
surface.plot_trisurf(x, y, z, triangles=contour.faces)
surface.set_box_aspect(contour.measure()["box_mm"])
surface.set(title="surface (mm, LPS)", xlabel="x", ylabel="y", zlabel="z")
figure.tight_layout()
figure.savefig("torus.png", dpi=100)
