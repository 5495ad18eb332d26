// @ts-check
// Keys give commands. Fields that take keys themselves keep them.

/**
 * @typedef {object} Commands
 * @property {(side: number, up: number, nearer: number) => void} turn
 * @property {(right: number, up: number) => void} slide
 * @property {Record<string, () => void>} plain by the key; of a letter the capital, where it means something else
 * @property {(body: number, isAlone: boolean) => void} body
 */

const kTurn = Math.PI / 24;

/** @param {Commands} commands */
export function listenToKeys(commands) {
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = /** @type {HTMLElement} */ (event.target);
    const isField = target.tagName === 'SELECT' || (target instanceof HTMLInputElement && target.type === 'range');
    const isButton = target.tagName === 'BUTTON' || target.tagName === 'SUMMARY' || target instanceof HTMLInputElement;
    if (isField && /^(Arrow|Home|End|Page)/.test(event.key)) return;
    // There one chooses by letters and digits.
    if (target.tagName === 'SELECT' && event.key.length === 1) return;
    if (isButton && (event.key === ' ' || event.key === 'Enter')) return;
    if (handle(event, commands)) event.preventDefault();
  });
}

/** @param {KeyboardEvent} event @param {Commands} commands */
function handle(event, commands) {
  const arrows = /** @type {Record<string, [number, number]>} */ (
      {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]});
  const arrow = arrows[event.key];
  if (arrow && event.shiftKey) commands.slide(arrow[0] * 0.15, arrow[1] * 0.15);
  else if (arrow) commands.turn(arrow[0] * kTurn, -arrow[1] * kTurn, 1);
  if (arrow) return true;
  const digit = /^Digit([1-9])$/.exec(event.code);
  if (digit) {
    commands.body(Number(digit[1]) - 1, event.shiftKey);
    return true;
  }
  if (event.key === '+' || event.key === '=') commands.turn(0, 0, 0.85);
  else if (event.key === '-') commands.turn(0, 0, 1 / 0.85);
  else {
    const command = commands.plain[event.key] ?? commands.plain[event.key.toLowerCase()];
    if (!command) return false;
    command();
  }
  return true;
}
