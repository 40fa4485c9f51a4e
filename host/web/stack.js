// A model as its contours stacked, seen obliquely from any side. Nearer layers are never below farther
// ones while one looks down on them, so drawing from the lowest up hides what is behind: no depth
// buffer, no library.
import {pen, colour} from '/assets/canvas.js';

// `layers`: [{z, loops}], from the lowest up. `eye`: {turn, tilt} in degrees.
export function drawStack(canvas, layers, box, eye) {
  const {context, width, height} = pen(canvas, 0.9);
  const [turn, tilt] = [eye.turn * Math.PI / 180, eye.tilt * Math.PI / 180];
  const middle = [0, 1, 2].map((i) => (box.low[i] + box.high[i]) / 2);
  const reach = Math.hypot(...[0, 1, 2].map((i) => box.high[i] - box.low[i])) || 1;
  const scale = 0.94 * Math.min(width, height) / reach;
  const project = ([x, y], z) => {
    const [dx, dy, dz] = [x - middle[0], y - middle[1], z - middle[2]];
    const away = dx * Math.sin(turn) + dy * Math.cos(turn);
    return [width / 2 + (dx * Math.cos(turn) - dy * Math.sin(turn)) * scale,
      height / 2 - (dz * Math.cos(tilt) + away * Math.sin(tilt)) * scale];
  };
  context.strokeStyle = colour('--accent');
  context.lineWidth = 0.7;
  for (const {z, loops} of layers) {
    context.beginPath();
    for (const {points} of loops) {
      points.forEach((point, i) => context[i ? 'lineTo' : 'moveTo'](...project(point, z)));
      context.closePath();
    }
    const share = (z - box.low[2]) / Math.max(box.high[2] - box.low[2], 1e-6);
    context.fillStyle = `hsl(212 55% ${Math.round(38 + 42 * share)}%)`;
    context.fill('evenodd');
    context.stroke();
  }
}
