// @ts-check
// The colours of what is drawn. A test computes them as the colour-blind see them, and how far apart they are then.

/** Of bodies: light, so that red triangles and dark curves stand out. */
export const kPalette = ['#93b4d4', '#e6c583', '#5db7aa', '#868ac2', '#d1f5c2', '#abb487'];

/** Triangles that intersect. */
export const kMarked = '#d3203c';

/** @typedef {{curve: string, contact: string, gap: string, line: string, box: string}} MarkColors */

/** The colours of what lies over bodies, by theme. @type {{light: MarkColors, dark: MarkColors}} */
export const kMarks = {
  light: {curve: '#14141c', contact: '#5b2a96', gap: '#00666b', line: '#44566a', box: '#a04a00'},
  dark: {curve: '#ffffff', contact: '#d3b5ff', gap: '#78fc87', line: '#e6eefa', box: '#ffb454'},
};

/** The brightness of bodies: on a dark ground marks are light, and bodies darker than these. */
export const kBrightness = {light: 1, dark: 0.78};
