// The printer's picture, where the daemon was told of a camera.
import {ask} from '/assets/api.js';
import {$, quietly} from '/assets/page.js';

export function start() {
  return quietly(async () => {
    const {url} = await ask('GET', 'camera');
    $('camera').hidden = !url;
    if (url && $('camera-picture').src !== url) $('camera-picture').src = url;
  });
}

function works(yes) {
  $('camera-picture').hidden = !yes;
  $('camera-fault').hidden = yes;
}

function follow(picture) {
  picture.addEventListener('load', () => works(true));
  picture.addEventListener('error', () => works(false));
}

follow($('camera-picture'));
$('camera-again').addEventListener('click', () => {
  // A new element, for the same address would not be asked again.
  const again = $('camera-picture').cloneNode();
  $('camera-picture').replaceWith(again);
  follow(again);
});
