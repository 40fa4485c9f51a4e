// Canvases as sharp as the screen, in the colours of the page.

export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// A blank canvas to draw on, measured in CSS pixels. `ratio`: its height over its width.
export function pen(canvas, ratio) {
  const width = canvas.clientWidth || 1;
  const height = Math.round(width * ratio);
  const density = window.devicePixelRatio || 1;
  canvas.width = Math.round(width * density);
  canvas.height = Math.round(height * density);
  const context = canvas.getContext('2d');
  context.scale(density, density);
  return {context, width, height};
}

// Calls `draw` whenever the canvas gets another width, or the page other colours.
export function redrawn(canvas, draw) {
  let width = 0;
  new ResizeObserver(() => {
    if (canvas.clientWidth === width) return;
    width = canvas.clientWidth;
    draw();
  }).observe(canvas);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
}

// From mm on the bed to pixels: `box` ({low, high}) in the middle, as large as it goes.
export function view(box, width, height) {
  const spans = [box.high[0] - box.low[0], box.high[1] - box.low[1]];
  const scale = 0.94 * Math.min(width / Math.max(spans[0], 1e-6), height / Math.max(spans[1], 1e-6));
  return {
    scale,
    x: (v) => width / 2 + (v - (box.low[0] + box.high[0]) / 2) * scale,
    y: (v) => height / 2 - (v - (box.low[1] + box.high[1]) / 2) * scale,
  };
}
