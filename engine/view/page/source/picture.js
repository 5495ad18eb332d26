// @ts-check
// The picture as a PNG, with what is said about it.

/**
 * @param {import('./stage.js').Stage} stage @param {string[]} lines above the picture
 * @returns {Promise<Blob>}
 */
export function pictureOf(stage, lines) {
  stage.drawFine();
  const {canvas} = stage, ratio = canvas.width / Math.max(1, canvas.clientWidth);
  const copy = document.createElement('canvas');
  copy.width = canvas.width;
  copy.height = canvas.height;
  const pen = copy.getContext('2d');
  if (!pen) return Promise.reject(new Error('no picture can be drawn here'));
  const style = getComputedStyle(document.body);
  pen.fillStyle = style.getPropertyValue('--ground');
  pen.fillRect(0, 0, copy.width, copy.height);
  pen.drawImage(canvas, 0, 0);
  pen.scale(ratio, ratio);
  pen.fillStyle = style.getPropertyValue('--ink');
  lines.forEach((line, i) => {
    pen.font = `${i === 0 ? 600 : 400} 14px system-ui, sans-serif`;
    pen.fillText(line, 14, 24 + 20 * i, canvas.clientWidth - 28);
  });
  const bar = document.getElementById('scale-line'), text = document.getElementById('scale-text');
  const long = bar?.clientWidth ?? 0, low = canvas.clientHeight - 30;
  pen.fillRect(14, low, long, 2);
  pen.fillRect(14, low - 5, 2, 6);
  pen.fillRect(12 + long, low - 5, 2, 6);
  pen.fillText(text?.textContent ?? '', 14, low + 18);
  return new Promise((resolve, reject) =>
    copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture cannot be kept'))), 'image/png'));
}
