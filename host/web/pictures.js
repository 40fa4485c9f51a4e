// Small pictures of models, drawn by the daemon; asked for when they come into sight, one after the other.
import {askBlob} from '/assets/api.js';

const KEPT = 500;

const known = new Map();  // of a file as it was uploaded: its picture, or null if it has none
let queue = Promise.resolve();

const keyOf = ({name, created, size}) => `${created} ${size} ${name}`;

async function load(file) {
  const key = keyOf(file);
  if (!known.has(key)) {
    try {
      const blob = await askBlob(`files/${encodeURIComponent(file.name)}/picture`);
      known.set(key, await createImageBitmap(blob));
    } catch {
      known.set(key, null);  // what cannot be sliced says so when it is looked into or printed
    }
    if (known.size > KEPT) known.delete(known.keys().next().value);
  }
  return known.get(key);
}

function paint(canvas, bitmap) {
  if (!bitmap) return;
  const scale = Math.min(canvas.width / bitmap.width, canvas.height / bitmap.height);
  const [width, height] = [bitmap.width * scale, bitmap.height * scale];
  canvas.getContext('2d').drawImage(bitmap, (canvas.width - width) / 2, (canvas.height - height) / 2, width, height);
}

const seen = new IntersectionObserver((entries) => {
  for (const {target, isIntersecting} of entries) {
    if (!isIntersecting) continue;
    seen.unobserve(target);
    queue = queue.then(async () => target.isConnected && paint(target, await load(target.file)));
  }
});

export function picture(file) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 144;
  canvas.className = 'picture';
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', `picture of ${file.name}`);
  canvas.file = file;
  if (known.has(keyOf(file))) paint(canvas, known.get(keyOf(file)));
  else seen.observe(canvas);
  return canvas;
}
