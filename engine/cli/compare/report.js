// @ts-check
// A report's tables are sorted by their headings and filtered by words, and its cases shown in the viewer. Without this
// script all of it is there as it was written.

/** A number where it is one, so that 9 comes before 10. @param {HTMLTableRowElement} row @param {number} column */
function valueOf(row, column) {
  const text = (row.cells[column]?.textContent ?? '').trim(), number = Number(text);
  return text === '' || Number.isNaN(number) ? text : number;
}

/** Numbers before words. @param {string|number} a @param {string|number} b */
function compare(a, b) {
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  if (typeof a !== typeof b) return typeof a === 'number' ? -1 : 1;
  return String(a).localeCompare(String(b), 'en', {numeric: true});
}

/** @param {HTMLTableElement} table @param {number} column */
function sort(table, column) {
  const headings = [...table.rows[0].cells], heading = headings[column];
  const isAscending = heading.getAttribute('aria-sort') !== 'ascending';
  for (const each of headings) each.removeAttribute('aria-sort');
  heading.setAttribute('aria-sort', isAscending ? 'ascending' : 'descending');
  const rows = [...table.rows].slice(1);
  rows.sort((a, b) => (isAscending ? 1 : -1) * compare(valueOf(a, column), valueOf(b, column)));
  rows.forEach((row) => row.parentNode?.append(row));
}

/** @param {HTMLTableElement} table */
function makeSortable(table) {
  [...table.rows[0].cells].forEach((heading, column) => {
    const button = document.createElement('button');
    button.textContent = heading.textContent;
    button.title = 'Sort by this';
    button.addEventListener('click', () => sort(table, column));
    heading.replaceChildren(button);
  });
}

/** A field over some things, which stay if they have all of its words. @param {Element} within @param {() => Iterable<Element>} things */
function makeFilter(within, things) {
  const field = document.createElement('input');
  field.type = 'search';
  field.className = 'filter';
  field.placeholder = 'filter by words';
  field.setAttribute('aria-label', 'Filter by words');
  field.addEventListener('input', () => {
    const words = field.value.toLowerCase().split(/\s+/);
    for (const thing of things()) {
      const text = (thing.textContent ?? '').toLowerCase();
      thing.classList.toggle('hidden', !words.every((word) => text.includes(word)));
    }
  });
  within.prepend(field);
}

/** The viewer stands in a frame of its own; buttons lead to a case in it. */
function joinViewer() {
  const frame = document.getElementById('viewer');
  if (!(frame instanceof HTMLIFrameElement)) return;
  const page = () => /** @type {any} */ (frame.contentWindow)?.grazePage;
  const cases = [...document.querySelectorAll('.case')];
  for (const button of document.querySelectorAll('.turn')) {
    button.addEventListener('click', () => {
      page()?.player.go(Number(/** @type {HTMLElement} */ (button).dataset.frame));
      for (const each of cases) each.classList.toggle('shown', each.contains(button));
      frame.scrollIntoView({block: 'nearest', behavior: 'smooth'});
    });
  }
  // Stills give way to a picture that can be turned, where there is one.
  const look = () => {
    if (page()) document.body.classList.add('has-picture');
    else if (frame.contentDocument?.querySelector('.refusal') === null) setTimeout(look, 100);
  };
  look();
}

document.body.classList.add('has-script');
for (const table of /** @type {NodeListOf<HTMLTableElement>} */ (document.querySelectorAll('table.sorted'))) {
  makeSortable(table);
  if (table.rows.length > 2) makeFilter(/** @type {HTMLElement} */ (table.parentElement), () => [...table.rows].slice(1));
}
const list = document.querySelector('.list');
if (list && list.querySelectorAll('.case').length > 1) makeFilter(list, () => list.querySelectorAll('.case'));
joinViewer();
