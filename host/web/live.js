// The layer under way: what of it is laid, and what is to come.
import {ask} from '/assets/api.js';
import {$, quietly, tell} from '/assets/page.js';
import {colour, pen, redrawn, view} from '/assets/canvas.js';

const BEAD_MM = 0.45;

let shown = null;   // as the daemon told it
let box = null;     // of all layers seen of this print, so that the picture stands still
let printing = null;  // the job, as last told
let asking = false;

function grow(paths) {
  for (const {points} of paths) {
    for (const [x, y] of points) {
      box ??= {low: [x, y], high: [x, y]};
      box.low = [Math.min(box.low[0], x), Math.min(box.low[1], y)];
      box.high = [Math.max(box.high[0], x), Math.max(box.high[1], y)];
    }
  }
}

// Pieces of `paths` from the one that line `from` makes to that before line `to`.
function trace(context, at, from, to) {
  context.beginPath();
  for (const {line, points} of shown.paths) {
    const first = Math.max(from - line, 0);
    const last = Math.min(to - line, points.length - 1);
    if (first >= last) continue;
    context.moveTo(at.x(points[first][0]), at.y(points[first][1]));
    for (let i = first + 1; i <= last; ++i) context.lineTo(at.x(points[i][0]), at.y(points[i][1]));
  }
  context.stroke();
}

// Where the nozzle is once `lines` of the layer are done.
function nozzle(lines) {
  let where = null;
  for (const {line, points} of shown.paths) {
    if (line >= lines) break;
    where = points[Math.min(lines - line, points.length - 1)];
  }
  return where;
}

function draw() {
  if (!shown || !box) return;
  const {context, width, height} = pen($('live'), 0.75);
  const at = view(box, width, height);
  const done = Math.min(Math.max(printing.lines - shown.lines_before, 0), shown.lines);
  context.lineCap = context.lineJoin = 'round';
  context.lineWidth = Math.max(BEAD_MM * at.scale * 0.8, 1);
  context.strokeStyle = colour('--to-come');
  trace(context, at, done, Infinity);
  context.strokeStyle = colour('--accent');
  trace(context, at, 0, done);
  const where = nozzle(done);
  if (where) {
    context.fillStyle = colour('--nozzle');
    context.beginPath();
    context.arc(at.x(where[0]), at.y(where[1]), 5, 0, 2 * Math.PI);
    context.fill();
  }
  $('live').setAttribute('aria-label',
    `layer ${shown.layer}, ${Math.round(100 * done / Math.max(shown.lines, 1))} % laid`);
}

async function fetchLayer() {
  asking = true;
  const layer = await quietly(() => ask('GET', 'printer/layer'));
  asking = false;
  if (!layer || !printing) return;
  shown = layer;
  grow(layer.paths);
  $('live').hidden = $('live-key').hidden = $('leave-out').hidden = false;
  draw();
}

function clear() {
  shown = box = null;
  $('live').hidden = $('live-key').hidden = $('leave-out').hidden = true;
}

// `job`: as the daemon tells it, or null.
export function show(job) {
  if (!job || job.id !== printing?.id) clear();
  printing = job;
  if (!job || !job.layer) return;
  if (shown?.layer === job.layer) {
    draw();
  } else if (!asking) {
    fetchLayer();
  }
}

// Where on the bed the picture was pointed at.
function point({offsetX, offsetY}) {
  if (!box) return;
  const at = view(box, $('live').clientWidth, $('live').clientHeight);
  $('leave-out').open = true;
  $('leave-out-x').value = ((offsetX - at.x(0)) / at.scale).toFixed(1);
  $('leave-out-y').value = ((at.y(0) - offsetY) / at.scale).toFixed(1);
}

async function leaveOut(event) {
  event.preventDefault();
  const [x, y] = [$('leave-out-x').valueAsNumber, $('leave-out-y').valueAsNumber];
  if (!confirm(`Go on without what stands at X ${x}, Y ${y}? It cannot be taken back.`)) return;
  if (await tell(`jobs/${printing.id}/cancel-object`, {x, y})) $('leave-out').open = false;
}

$('live').addEventListener('click', point);
$('leave-out-form').addEventListener('submit', leaveOut);
redrawn($('live'), draw);
