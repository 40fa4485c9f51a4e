-- Plain arithmetic: a six-lobed vase that turns as it rises, hollow, with a bottom.
local turn = z * 0.03
local u = x * cos(turn) - y * sin(turn)
local v = x * sin(turn) + y * cos(turn)
local radius = 18 + 2.5 * cos(6 * atan2(v, u)) + 4 * sin(z * 0.08)
local body = (sqrt(x ^ 2 + y ^ 2) - radius) * 0.7

local vase = max(body, -z, z - 60):bounds(-27, -27, 0, 27, 27, 60)
local hollow = max(body + 1.4, 2 - z)
return difference(vase, hollow)
