-- The demo: a hollow ball of 40 mm with a wall of 1.6 mm, filled with gyroid sheets of 1.2 mm. Where they meet, the seam is
-- rounded: a sheet that touches the wall at a sharp angle leaves a wedge thinner than any bead.
local ball = sphere(20)

return intersection(ball, smooth_union(2, ball:shell(1.6), gyroid(10, 1.2)))
