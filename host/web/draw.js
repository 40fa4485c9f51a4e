// Pictures on canvases, in the colours of the page.

function pen(canvas) {
  const context = canvas.getContext('2d');
  context.clearRect(0, 0, canvas.width, canvas.height);
  return context;
}

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// The loops of one layer, even-odd: solid is filled.
export function drawLayer(canvas, layer, box) {
  const context = pen(canvas);
  const size = Math.max(box.high[0] - box.low[0], box.high[1] - box.low[1], 1e-6);
  const scale = 0.95 * canvas.width / size;
  const x = (v) => canvas.width / 2 + (v - (box.low[0] + box.high[0]) / 2) * scale;
  const y = (v) => canvas.height / 2 - (v - (box.low[1] + box.high[1]) / 2) * scale;
  context.beginPath();
  for (const loop of layer.loops) {
    loop.points.forEach(([px, py], i) => (i ? context.lineTo(x(px), y(py)) : context.moveTo(x(px), y(py))));
    context.closePath();
  }
  context.fillStyle = colour('--accent');
  context.globalAlpha = 0.35;
  context.fill('evenodd');
  context.globalAlpha = 1;
  context.strokeStyle = colour('--accent');
  context.stroke();
}

// Curves of nozzle and bed over the last readings, 0 to 300 °C.
export function drawHeat(canvas, readings) {
  const context = pen(canvas);
  const most = 300;
  const x = (i) => i / Math.max(readings.length - 1, 1) * canvas.width;
  const y = (celsius) => canvas.height * (1 - celsius / most);
  context.font = '12px system-ui';
  context.fillStyle = colour('--ink');
  for (const celsius of [100, 200]) context.fillText(`${celsius} °C`, 4, y(celsius));
  for (const [heater, name] of [['nozzle', '--danger'], ['bed', '--accent']]) {
    context.strokeStyle = colour(name);
    context.beginPath();
    readings.forEach((reading, i) => context.lineTo(x(i), y(reading[heater]?.actual ?? 0)));
    context.stroke();
  }
}
