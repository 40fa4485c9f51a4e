// What is printed.

// Under half a minute of printing at sixty times the speed; a tower is tall enough to be interrupted.
export const TILE = 'return box(12, 12, 1):move(0, 0, 0.5)\n';
export const TOWER = 'return difference(box(24, 24, 20):move(0, 0, 10), cylinder(6, 60))\n';
// Wider apart than high, so that the picture is as wide as its canvas.
export const TOWERS = 'return union(cylinder(8, 20):move(-30, 0, 10), cylinder(8, 20):move(30, 0, 10))\n';
export const BROKEN = 'return sphere(10\n';
const zigzag = Array.from({length: 40}, (_, i) => `G1 X${20 + i % 2 * 50} Y${20 + i} F6000`);
export const MOVES = ['G90', 'M83', 'G28', ...zigzag, 'M400', ''].join('\n');
