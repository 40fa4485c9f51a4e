#include "core/formats/lua_prelude.h"

namespace slipstick {

namespace {

// `raw` holds the functions of lua_expression.cpp: raw.bounded(e, six numbers), raw.rotated(e,
// three), raw.scaled(e, three), raw.moved(e, three), raw.remapped(e, x, y, z), raw.box(e),
// raw.methods. Errors are raised at the level of the script's own line.
constexpr std::string_view kPrelude = R"lua(
local raw, huge, pi = raw, math.huge, math.pi
local methods = raw.methods

local function number(value, what, level)
  if type(value) ~= "number" or value ~= value or value == huge or value == -huge then
    error(what .. " must be a number", (level or 1) + 3)
  end
  return value
end
local function positive(value, what)
  if number(value, what, 2) <= 0 then error(what .. " must be greater than 0", 4) end
  return value
end
local function solid(value, what)
  if type(value) == "number" then return x * 0 + value end
  if type(value) ~= "userdata" then error(what .. " must be a solid", 4) end
  return value
end

local function norm(...)
  local sum = 0
  for _, v in ipairs({...}) do sum = sum + square(v) end
  return sqrt(sum)
end

-- Primitives: exact distances, in mm, centred on the origin.
function sphere(r)
  positive(r, "sphere: radius")
  return raw.bounded(norm(x, y, z) - r, -r, -r, -r, r, r, r)
end

function box(sx, sy, sz, rounding)
  positive(sx, "box: x size") positive(sy, "box: y size") positive(sz, "box: z size")
  local r = number(rounding or 0, "box: rounding")
  if r < 0 or 2 * r > math.min(sx, sy, sz) then
    error("box: rounding must be 0 to half the smallest side", 3)
  end
  local hx, hy, hz = sx / 2, sy / 2, sz / 2
  local qx, qy, qz = abs(x) - (hx - r), abs(y) - (hy - r), abs(z) - (hz - r)
  local outside = norm(max(qx, 0), max(qy, 0), max(qz, 0))
  local inside = min(max(qx, qy, qz), 0)
  return raw.bounded(outside + inside - r, -hx, -hy, -hz, hx, hy, hz)
end

function cylinder(r, h)
  positive(r, "cylinder: radius") positive(h, "cylinder: height")
  local qr, qz = norm(x, y) - r, abs(z) - h / 2
  local f = norm(max(qr, 0), max(qz, 0)) + min(max(qr, qz), 0)
  return raw.bounded(f, -r, -r, -h / 2, r, r, h / 2)
end

-- From radius r1 at the bottom to r2 at the top.
function cone(r1, r2, h)
  number(r1, "cone: bottom radius") number(r2, "cone: top radius") positive(h, "cone: height")
  if r1 < 0 or r2 < 0 or r1 + r2 == 0 then error("cone: radii must not be negative, nor both 0", 3) end
  local slope = math.sqrt(h * h + (r1 - r2) ^ 2)
  local side = ((norm(x, y) - (r1 + r2) / 2) * h + z * (r1 - r2)) / slope
  local r = math.max(r1, r2)
  return raw.bounded(max(side, abs(z) - h / 2), -r, -r, -h / 2, r, r, h / 2)
end

function torus(R, r)
  positive(R, "torus: ring radius") positive(r, "torus: tube radius")
  local a = R + r
  return raw.bounded(norm(norm(x, y) - R, z) - r, -a, -a, -r, a, a, r)
end

-- Where nx*x + ny*y + nz*z <= d, for the normalised normal.
function half_space(nx, ny, nz, d)
  number(nx, "half_space: normal") number(ny, "half_space: normal") number(nz, "half_space: normal")
  local l = math.sqrt(nx * nx + ny * ny + nz * nz)
  if l == 0 then error("half_space: the normal must not be 0", 3) end
  return (x * nx + y * ny + z * nz) / l - number(d, "half_space: distance")
end

function capsule(x1, y1, z1, x2, y2, z2, r)
  for _, v in ipairs({x1, y1, z1, x2, y2, z2}) do number(v, "capsule: end") end
  positive(r, "capsule: radius")
  local dx, dy, dz = x2 - x1, y2 - y1, z2 - z1
  local l2 = dx * dx + dy * dy + dz * dz
  if l2 == 0 then error("capsule: the ends must differ; use sphere", 3) end
  local t = min(max(((x - x1) * dx + (y - y1) * dy + (z - z1) * dz) / l2, 0), 1)
  local f = norm(x - x1 - t * dx, y - y1 - t * dy, z - z1 - t * dz) - r
  local lo, hi = math.min, math.max
  return raw.bounded(f, lo(x1, x2) - r, lo(y1, y2) - r, lo(z1, z2) - r,
                     hi(x1, x2) + r, hi(y1, y2) + r, hi(z1, z2) + r)
end

-- Triply periodic minimal surfaces as sheets. |g| grows by about `gradient` a radian off the surface, on
-- average over it (harmonic mean, by sampling), so sheets are `thickness` thick on average.
local function sheet(g, gradient, period, thickness, name)
  positive(period, name .. ": period") positive(thickness, name .. ": thickness")
  return abs(g) / (gradient * 2 * pi / period) - thickness / 2
end
local function phases(period)
  if type(period) ~= "number" or period <= 0 then period = 1 end  -- reported by sheet
  local k = 2 * pi / period
  return x * k, y * k, z * k
end

function gyroid(period, thickness)
  local u, v, w = phases(period)
  local g = sin(u) * cos(v) + sin(v) * cos(w) + sin(w) * cos(u)
  return sheet(g, 1.53, period, thickness, "gyroid")
end

function schwarz_p(period, thickness)
  local u, v, w = phases(period)
  return sheet(cos(u) + cos(v) + cos(w), 1.31, period, thickness, "schwarz_p")
end

function diamond(period, thickness)
  local u, v, w = phases(period)
  local g = sin(u) * sin(v) * sin(w) + sin(u) * cos(v) * cos(w) + cos(u) * sin(v) * cos(w)
            + cos(u) * cos(v) * sin(w)
  return sheet(g, 1.49, period, thickness, "diamond")
end

function lidinoid(period, thickness)
  local u, v, w = phases(period)
  local g = (sin(2 * u) * cos(v) * sin(w) + sin(2 * v) * cos(w) * sin(u)
             + sin(2 * w) * cos(u) * sin(v)) / 2
            - (cos(2 * u) * cos(2 * v) + cos(2 * v) * cos(2 * w) + cos(2 * w) * cos(2 * u)) / 2 + 0.15
  return sheet(g, 1.29, period, thickness, "lidinoid")
end

-- Set operations.
local function folded(name, join, ...)
  local n = select("#", ...)
  if n == 0 then error(name .. " needs at least one solid", 4) end
  local result
  for i = 1, n do
    local s = solid((select(i, ...)), name .. ": argument " .. i)
    result = result and join(result, s) or s
  end
  return result
end
local function two(f) return function(a, b) return f(a, b) end end

function union(...) return (folded("union", two(min), ...)) end
function intersection(...) return (folded("intersection", two(max), ...)) end
function difference(a, ...)
  solid(a, "difference: argument 1")
  if select("#", ...) == 0 then return a end
  return raw.boxed_as(max(a, -folded("difference", two(min), ...)), a)
end

-- Blends: a polynomial minimum that rounds the seam over a width of k, written so that nothing is chosen between a and b
-- along the seam: bounds of it and of its gradient stay narrow there.
local function within(d, k) return min(max(d, -k), k) end
local function smooth_min(k)
  return function(a, b)
    local blend = min(b, a + k) - square(k - within(a - b, k)) / (4 * k)
    return raw.boxed_around(blend, min(a, b), k / 4)
  end
end
function smooth_union(k, ...)
  positive(k, "smooth_union: width")
  return (folded("smooth_union", smooth_min(k), ...))
end
local function smooth_max(k)
  return function(a, b)
    local blend = max(b, a - k) + square(k + within(a - b, k)) / (4 * k)
    return raw.boxed_as(blend, max(a, b))
  end
end
function smooth_intersection(k, ...)
  positive(k, "smooth_intersection: width")
  return (folded("smooth_intersection", smooth_max(k), ...))
end
function smooth_difference(k, a, ...)
  positive(k, "smooth_difference: width")
  solid(a, "smooth_difference: argument 2")
  local rest = folded("smooth_difference", two(min), ...)
  return raw.boxed_as(smooth_max(k)(a, -rest), a)
end

-- Transforms, as methods: s:move(1, 2, 3).
function methods.move(s, dx, dy, dz)
  return raw.moved(s, number(dx, "move: x"), number(dy, "move: y"), number(dz, "move: z"))
end
function methods.rotate(s, ax, ay, az)
  return raw.rotated(s, number(ax, "rotate: x"), number(ay, "rotate: y"), number(az, "rotate: z"))
end
function methods.scale(s, sx, sy, sz)
  sy, sz = sy or sx, sz or sx
  positive(sx, "scale: x") positive(sy, "scale: y") positive(sz, "scale: z")
  local f = raw.scaled(s, sx, sy, sz)
  return raw.boxed_as(f * math.min(sx, sy, sz), f)
end
-- Adds the mirror image in the plane through the origin across `axis`.
function methods.mirror(s, axis)
  if axis ~= "x" and axis ~= "y" and axis ~= "z" then error('mirror: axis must be "x", "y" or "z"', 3) end
  return min(s, raw.scaled(s, axis == "x" and -1 or 1, axis == "y" and -1 or 1, axis == "z" and -1 or 1))
end
-- nx * ny * nz copies, px, py, pz apart, the first in place. Copies must not reach beyond their cells.
function methods.array(s, px, py, pz, nx, ny, nz)
  local x0, y0, z0, x1, y1, z1 = raw.box(s)
  -- Cells lie about the middle of the solid, wherever it was moved to.
  local function axis(v, p, n, low, high, what)
    n = n or 1
    if math.type(n) ~= "integer" or n < 1 then error("array: count must be a whole number from 1", 4) end
    if n == 1 then return v end
    positive(p, "array: spacing in " .. what)
    local middle = 0.5 * (low + high)
    if math.abs(middle) == math.huge or middle ~= middle then middle = 0 end
    return v - p * min(max(floor((v - middle) / p + 0.5), 0), n - 1)
  end
  local f = raw.remapped(s, axis(x, px, nx, x0, x1, "x"), axis(y, py, ny, y0, y1, "y"),
                         axis(z, pz, nz, z0, z1, "z"))
  return raw.bounded(f, x0, y0, z0, x1 + px * ((nx or 1) - 1), y1 + py * ((ny or 1) - 1),
                     z1 + pz * ((nz or 1) - 1))
end
-- What lies within `t` of the surface, on the inside.
function methods.shell(s, t)
  positive(t, "shell: thickness")
  return raw.boxed_as(max(s, -(s + t)), s)
end
function methods.offset(s, d)
  return raw.boxed_around(s - number(d, "offset: distance"), s, math.max(d, 0))
end
function methods.bounds(s, x0, y0, z0, x1, y1, z1)
  for _, v in ipairs({x0, y0, z0, x1, y1, z1}) do number(v, "bounds") end
  if z1 == nil or x0 >= x1 or y0 >= y1 or z0 >= z1 then
    error("bounds: six numbers, x0, y0, z0 below x1, y1, z1", 3)
  end
  return raw.bounded(s, x0, y0, z0, x1, y1, z1)
end
)lua";

}  // namespace

std::string_view lua_prelude() {
  return kPrelude;
}

}  // namespace slipstick
