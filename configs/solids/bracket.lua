-- Booleans: a rounded plate with holes, an upright and a smooth fillet between them.
local plate = box(60, 40, 6, 2):move(0, 0, 3)
local upright = box(60, 6, 30, 2):move(0, -17, 15)
local hole = cylinder(3, 20)

local body = intersection(smooth_union(6, plate, upright), box(60, 40, 30):move(0, 0, 15))

return difference(body,
                  hole:move(-15, 6, 3):array(30, 0, 0, 2),
                  hole:rotate(90, 0, 0):move(0, -17, 20))
