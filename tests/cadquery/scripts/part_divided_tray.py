# A tray divided in cells by walls from nested loops.
import cadquery as cq

nx = 3
ny = 2
cell = 24.0
wall = 1.6
tray = cq.Workplane("XY").box(nx * cell + wall, ny * cell + wall, 18, centered=False)
for i in range(nx):
    for j in range(ny):
        x = wall + i * cell
        y = wall + j * cell
        pocket = cq.Workplane("XY", origin=(x, y, 2)).box(cell - wall, cell - wall, 30, centered=False)
        tray = tray.cut(pocket.edges("|Z").fillet(3))
result = tray.edges("|Z and (>XY or <XY)").fillet(1.2)
