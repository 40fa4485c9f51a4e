// What is looked for in a page; each function runs in the browser and stands on its own.

// Texts whose contrast is under 4.5 (WCAG 2, AA; switched-off controls are exempt).
export function faint() {
  const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
  const linear = (v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
  const over = ([r, g, b, alpha = 1], below) => [r, g, b].map((v, i) => v * alpha + below[i] * (1 - alpha));
  const ground = (element) => {
    if (!element) return [255, 255, 255];
    const own = channels(getComputedStyle(element).backgroundColor);
    return (own[3] ?? 1) === 1 ? own : over(own, ground(element.parentElement));
  };
  const contrast = (element) => {
    const below = ground(element);
    const [a, b] = [luminance(over(channels(getComputedStyle(element).color), below)), luminance(below)];
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  };
  return [...document.body.querySelectorAll('*')]
    .filter((element) => element.checkVisibility() && !element.matches(':disabled') &&
      [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim()))
    .map((element) => [element, contrast(element)])
    .filter(([, ratio]) => ratio < 4.5)
    .map(([{tagName, id, textContent}, ratio]) => `${tagName} ${id} "${textContent.trim()}" ${ratio.toFixed(2)}`);
}

// Why the page is too narrow for what it holds: elements that stick out, and buttons too small for a finger.
export function narrow() {
  const width = document.documentElement.clientWidth;
  const faults = [];
  const {scrollWidth} = document.scrollingElement;
  if (scrollWidth > width) faults.push(`scrolls to ${scrollWidth} of ${width}`);
  for (const element of document.body.querySelectorAll('*')) {
    if (!element.checkVisibility()) continue;
    const box = element.getBoundingClientRect();
    if (box.width > 0 && (box.left < -1 || box.right > width + 1)) {
      const text = element.textContent.trim().slice(0, 30);
      faults.push(`${element.tagName} ${element.id} "${text}" ${box.left} to ${box.right}`);
    }
    if (element.matches('button') && (box.height < 36 || box.width < 36)) {
      faults.push(`${element.textContent} is ${box.width} x ${box.height}`);
    }
  }
  return faults;
}

// What has the focus, by its name, and why it could not be seen.
export function focused() {
  const element = document.activeElement;
  const name = (element.ariaLabel || element.labels?.[0]?.textContent || element.textContent).trim();
  if (element === document.body) return {name, faults: []};
  const style = getComputedStyle(element);
  const box = element.getBoundingClientRect();
  const faults = [];
  if (style.outlineStyle === 'none' || parseFloat(style.outlineWidth) < 2) faults.push('no outline');
  if (box.bottom < 0 || box.top > innerHeight) faults.push('out of sight');
  const bar = document.querySelector('header');
  if (!bar.contains(element) && box.bottom <= bar.getBoundingClientRect().bottom) faults.push('behind the header');
  return {name, faults};
}
