-- The demo: a hollow ball of 40 mm with a wall of 1.6 mm, filled with gyroid sheets of 1.2 mm.
local ball = sphere(20)
local filling = gyroid(10, 1.2)

return union(ball:shell(1.6), intersection(ball, filling))
